// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/direct_call.h"

#include <ros/subscription_callback_helper.h>
#include <ros/subscription_queue.h>
#include <tzc/direct_dispatch.h>

#include <algorithm>

#include "channel/fault_signals.h"
#include "roscpp/roscpp_access.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

using CallbackInfoPtr =
    std::decay_t<decltype(access::callbacks_(std::declval<ros::Subscription&>()).front())>;

/// Null unless the subscription has just one callback and it is called directly.
CallbackInfoPtr only_callback(ros::Subscription& subscription) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  const bool direct = callbacks.size() == 1 && callbacks.front()->callback_queue_ == direct_dispatch_queue();
  return direct ? callbacks.front() : CallbackInfoPtr();
}

bool is_empty(ros::SubscriptionQueue& queue) {
  const boost::mutex::scoped_lock lock(access::queue_mutex_(queue));
  return access::queue_size_(queue) == 0;
}

/// As roscpp: one callback of a subscription at a time, unless it allows more. Held while the callback runs,
/// so that a thread that unsubscribes waits for it.
void wait_for_turn(ros::SubscriptionQueue& queue, boost::unique_lock<boost::recursive_mutex>& turn) {
  if (access::allow_concurrent_callbacks_(queue)) return;
  turn = boost::unique_lock<boost::recursive_mutex>(access::callback_mutex_(queue), boost::try_to_lock);
  if (turn.owns_lock()) return;
  sync_point("direct: waits for a callback");
  turn.lock();
}

void call(ros::SubscriptionCallbackHelper& helper, const DirectMessage& message) {
  const boost::shared_ptr<void> decoded = message.decode(!helper.isConst());
  if (!decoded) return;
  ros::SubscriptionCallbackHelperCallParams params;
  params.event = ros::MessageEvent<void const>(decoded, message.connection_header, ros::Time::now(), false,
                                               ros::MessageEvent<void const>::CreateFunction());
  channel::keep_watching_write_faults();
  helper.call(params);
}

}  // namespace

bool has_direct_callback(ros::Subscription& subscription) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  return std::any_of(callbacks.begin(), callbacks.end(), [](const CallbackInfoPtr& callback) {
    return callback->callback_queue_ == direct_dispatch_queue();
  });
}

bool call_directly(ros::Subscription& subscription, const DirectMessage& message) {
  if (message.latched || access::enable_statistics(access::statistics_(subscription))) return false;
  const CallbackInfoPtr callback = only_callback(subscription);
  if (!callback || callback->helper_->getTypeInfo() != message.type) return false;
  const ros::SubscriptionQueuePtr queue = callback->subscription_queue_;
  boost::unique_lock<boost::recursive_mutex> turn;
  wait_for_turn(*queue, turn);
  // The callback may have been unsubscribed meanwhile, and then must not be called.
  if (!is_empty(*queue) || only_callback(subscription) != callback) return false;
  const ros::VoidConstPtr tracked = callback->tracked_object_.lock();
  if (!callback->has_tracked_object_ || tracked) call(*callback->helper_, message);
  return true;
}

}  // namespace detail
}  // namespace tzc
