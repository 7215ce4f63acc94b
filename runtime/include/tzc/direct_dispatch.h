// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <tzc/subscribe.h>

#include <utility>

namespace tzc {

/// A callback queue that needs no spinner: what arrives through shared memory is called back on the
/// transport's reader thread, right as it arrives, and what arrives over TCPROS on one thread of its own.
/// Saves the wake-up of a spinning thread. A slow callback delays the messages of its own publisher only.
/// Callbacks of one subscription never run concurrently, unless its options allow it. Owned by the library;
/// valid as long as the process runs.
ros::CallbackQueueInterface* direct_dispatch_queue();

/// tzc::subscribe with direct dispatch, in all its overloads: for latency-critical callbacks that are safe on
/// a thread other than the spinning one. The subscription ends with its ros::Subscriber; `node.shutdown()`
/// does not end it.
template <class... M, class... Args>
ros::Subscriber subscribe_direct(const ros::NodeHandle& node, Args&&... args) {
  ros::NodeHandle direct(node);
  direct.setCallbackQueue(direct_dispatch_queue());
  return subscribe<M...>(direct, std::forward<Args>(args)...);
}

}  // namespace tzc
