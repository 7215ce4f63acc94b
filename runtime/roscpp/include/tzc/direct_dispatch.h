// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <tzc/subscribe.h>

namespace tzc {

/// A callback queue that needs no spinner. The thread that reads a publisher's messages from shared memory
/// calls the callback as soon as one arrives; one further thread does so for messages over TCPROS, and on topics
/// to which this process was connected before their first direct callback. This saves the wake-up of a spinning
/// thread. A slow callback delays no other topic; callbacks of one subscription wait for each other, whoever
/// published, unless its options allow them to run concurrently. Owned by the library; valid while the process runs.
ros::CallbackQueueInterface* direct_dispatch_queue();

/// tzc::subscribe with direct dispatch, in all its overloads: for latency-critical callbacks that are safe on
/// a thread other than the spinning one. The subscription ends with its ros::Subscriber; `node.shutdown()`
/// does not end it.
template <class... M, class... Args>
ros::Subscriber subscribe_direct(const ros::NodeHandle& node, Args... args) {
  ros::NodeHandle direct(node);
  direct.setCallbackQueue(direct_dispatch_queue());
  return subscribe<M...>(direct, args...);
}

}  // namespace tzc
