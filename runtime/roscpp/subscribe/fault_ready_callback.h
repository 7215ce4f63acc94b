// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

namespace tzc {
namespace detail {

/// A callback that is called on a thread that does not block the signals of faults, and with TZC's handler as the first one: roscpp's
/// spinners with threads of their own block all signals, and other code may have installed a handler since. A callback that writes to a
/// shared message there would end the process. The callback itself if it is one already.
ros::CallbackInterfacePtr fault_ready(const ros::CallbackInterfacePtr& callback);

}  // namespace detail
}  // namespace tzc
