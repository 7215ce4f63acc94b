// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>

#include <functional>
#include <typeinfo>

namespace tzc {

/// What of a shared message the short way needs.
struct DirectMessage {
  const std::type_info& type;  ///< of the C++ class that decode gives
  const bool latched;
  const boost::shared_ptr<ros::M_string> connection_header;
  /// The message, or for a callback that may write a copy of its own; null when malformed.
  std::function<boost::shared_ptr<void>(bool writes)> decode;
};

/// The short way to the callback of a subscription that has just one and dispatches it directly: everything
/// that Subscription::handleMessage and SubscriptionQueue::call do for such a message, without a queue in
/// between. A callback that runs on another thread is waited for.
/// @return false: nothing was done, the message has to go roscpp's way. That is so for latched topics and for
/// topic statistics, for several callbacks, for callbacks of another type or queue, and while messages wait
/// in the subscription's queue, which come first.
bool call_directly(ros::Subscription& subscription, const DirectMessage& message);

}  // namespace tzc
