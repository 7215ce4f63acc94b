// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {

/// ros::spin() with one wake-up for a shared message instead of two: the calling thread reads the shared messages of
/// this node while it has nothing else to do, and is woken by their publishers. Callbacks, their thread and order,
/// queue sizes, timers, services, messages over TCPROS and shutdown are as with ros::spin(); while a callback runs, the
/// library's thread reads. Call it on one thread, as ros::spin(). It is ros::spin() where it has to be: when this
/// library was loaded after ros::init().
void spin();

}  // namespace tzc
