// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>

#include <functional>
#include <typeinfo>

namespace tzc {
namespace detail {

/// What call_directly needs of a shared message.
struct DirectMessage {
  const std::type_info& type;  ///< of the C++ class that decode gives
  const bool latched;
  const boost::shared_ptr<ros::M_string> connection_header;
  /// Returns the message, or a private copy for a callback that may write; null when malformed.
  std::function<boost::shared_ptr<void>(bool writes)> decode;
};

/// Whether a callback of the subscription is dispatched directly.
bool has_direct_callback(ros::Subscription& subscription);

/// Hot path to the callback of a subscription that has only one and dispatches it directly: does what
/// Subscription::handleMessage and SubscriptionQueue::call do for such a message, without a queue in between.
/// Waits for a callback that runs on another thread.
/// @return false: it did nothing, and the message must go through roscpp's queue. That is so for latched
/// topics, with topic statistics, for several callbacks, for callbacks of another type or queue, and while
/// earlier messages wait in the subscription's queue.
bool call_directly(ros::Subscription& subscription, const DirectMessage& message);

}  // namespace detail
}  // namespace tzc
