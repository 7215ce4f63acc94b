// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>
#include <ros/subscription_queue.h>
#include <ros/time.h>
#include <tzc/detail/codec.h>

#include <functional>
#include <type_traits>
#include <utility>

#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/concurrent_call.h"

namespace tzc {
namespace detail {

/// What a DirectCall needs to know of a shared message.
struct DirectMessage {
  const MessageCodec& codec;
  const bool latched;
  const boost::shared_ptr<ros::M_string> connection_header;
};

/// Makes the message that a callback gets: a copy of its own if it may write. Null: it is malformed.
using Decode = std::function<boost::shared_ptr<void>(bool may_write)>;

/// Whether a callback of the subscription is dispatched directly.
bool has_direct_callback(ros::Subscription& subscription);

/// The hot path to the callback of a subscription that has only one: what Subscription::handleMessage and
/// SubscriptionQueue::call do for such a message, without a queue in between. As long as this exists, no other callback of the
/// subscription runs, unless it allows more, and a thread that unsubscribes waits. Used on one thread.
class DirectCall {
 public:
  /// While a callback of the subscription runs on another thread. at_once: one that may run beside others has no turn.
  enum class Turn { waits, at_once };

  /// Empty: the message must go through roscpp's queue. That is so for latched topics, with topic statistics, for several
  /// callbacks, for a callback of another type, or whose queue does not lead to `queue`, and while earlier messages wait
  /// in the subscription's queue.
  static DirectCall prepare(ros::Subscription& subscription, const DirectMessage& message,
                            const ros::CallbackQueueInterface& queue, Turn turn);

  explicit operator bool() const { return callback_ != nullptr; }
  /// The callback may write to the message.
  bool writes() const { return writes_; }
  /// What an exception of the callback does: on a thread of TZC's it ends the process, as an unhandled one does with roscpp.
  enum class Thrown { leaves, ends_process };
  /// Unless the callback's tracked object has died. What `decode` throws leaves in any case.
  void call(const Decode& decode, Thrown thrown);

 private:
  using CallbackInfoPtr =
      std::decay_t<decltype(roscpp_access::callbacks_(std::declval<ros::Subscription&>()).front())>;

  static CallbackInfoPtr only_callback(ros::Subscription& subscription,
                                       const ros::CallbackQueueInterface& queue);
  bool take_turn(Turn turn);

  CallbackInfoPtr callback_;
  bool writes_ = false;
  ros::Time received_;
  boost::shared_ptr<ros::M_string> connection_header_;
  ros::SubscriptionQueuePtr queue_;
  boost::unique_lock<boost::recursive_mutex> turn_;
  ConcurrentCall concurrent_;  ///< where there are no turns
};

}  // namespace detail
}  // namespace tzc
