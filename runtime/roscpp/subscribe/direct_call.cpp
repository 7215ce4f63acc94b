// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/direct_call.h"

#include <ros/init.h>
#include <ros/subscription_callback_helper.h>
#include <tzc/direct_dispatch.h>

#include <algorithm>

#include "channel/fault_signals.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/writing_callback.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

bool is_empty(ros::SubscriptionQueue& queue) {
  const boost::mutex::scoped_lock lock(access::queue_mutex_(queue));
  return access::queue_size_(queue) == 0;
}

}  // namespace

bool has_direct_callback(ros::Subscription& subscription) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  return std::any_of(callbacks.begin(), callbacks.end(), [](const auto& callback) {
    return callback->callback_queue_ == direct_dispatch_queue();
  });
}

DirectCall DirectCall::prepare(ros::Subscription& subscription, const DirectMessage& message,
                               const ros::CallbackQueueInterface& queue, Turn turn) {
  DirectCall call;
  if (message.latched || access::enable_statistics(access::statistics_(subscription))) return call;
  call.callback_ = only_callback(subscription, queue);
  if (!call || call.callback_->helper_->getTypeInfo() != *message.codec.type) return DirectCall();
  call.writes_ = may_write(*call.callback_->helper_, message.codec);
  call.queue_ = call.callback_->subscription_queue_;
  call.received_ = ros::Time::now();
  // The callback may have been unsubscribed meanwhile, and then must not be called; nor while the node shuts down (waiting_end.h).
  if (!call.take_turn(turn) || !is_empty(*call.queue_) || ros::isShuttingDown() ||
      only_callback(subscription, queue) != call.callback_)
    return DirectCall();
  call.connection_header_ = message.connection_header;
  return call;
}

DirectCall::CallbackInfoPtr DirectCall::only_callback(ros::Subscription& subscription,
                                                      const ros::CallbackQueueInterface& queue) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  const bool is_only = callbacks.size() == 1 && leads_to(*callbacks.front()->callback_queue_, queue);
  return is_only ? callbacks.front() : CallbackInfoPtr();
}

bool DirectCall::take_turn(Turn turn) {
  if (access::allow_concurrent_callbacks_(*queue_)) {
    if (turn == Turn::at_once) return false;
    concurrent_ = ConcurrentCall(removal_id(callback_));
    return true;
  }
  turn_ = boost::unique_lock<boost::recursive_mutex>(access::callback_mutex_(*queue_), boost::try_to_lock);
  if (turn_.owns_lock()) return true;
  if (turn == Turn::at_once) return false;
  sync_point("direct: waits for a callback");
  turn_.lock();
  return true;
}

void DirectCall::call(const Decode& decode, Thrown thrown) {
  const ros::VoidConstPtr tracked = callback_->tracked_object_.lock();
  if (callback_->has_tracked_object_ && !tracked) return;
  const boost::shared_ptr<void> decoded = decode(writes());
  if (!decoded) return;
  ros::SubscriptionCallbackHelperCallParams params;
  params.event = ros::MessageEvent<void const>(decoded, connection_header_, received_, false,
                                               ros::MessageEvent<void const>::CreateFunction());
  channel::keep_watching_write_faults();
  if (thrown == Thrown::leaves) return callback_->helper_->call(params);
  [&]() noexcept { callback_->helper_->call(params); }();
}

}  // namespace detail
}  // namespace tzc
