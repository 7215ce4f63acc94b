// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/waiting_end.h"

#include <ros/subscription.h>
#include <ros/subscription_queue.h>
#include <ros/topic_manager.h>
#include <tzc/direct_dispatch.h>

#include <boost/weak_ptr.hpp>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "roscpp/roscpp_access.h"
#include "roscpp/roscpp_version.h"
#include "roscpp/subscribe/concurrent_call.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// What may be left of a direct callback when roscpp has forgotten it.
struct WaitingMessages {
  boost::weak_ptr<ros::SubscriptionQueue> queue;  ///< of its messages
  std::uint64_t id = 0;                           ///< of the callback in callback queues, an address
  boost::weak_ptr<void> callback = {};            ///< what lies there: no later callback does meanwhile
};

/// Empty: it has been unsubscribed already.
WaitingMessages queue_of(const std::string& topic, const ros::SubscriptionCallbackHelperPtr& callback) {
  ros::TopicManager& topics = *ros::TopicManager::instance();
  const boost::mutex::scoped_lock lock(access::subs_mutex_(topics));
  for (const ros::SubscriptionPtr& subscription : access::subscriptions_(topics)) {
    if (subscription->getName() != topic) continue;
    const boost::mutex::scoped_lock callbacks_lock(access::callbacks_mutex_(*subscription));
    for (const auto& one : access::callbacks_(*subscription))
      if (one->helper_ == callback) return {one->subscription_queue_, removal_id(one), one};
  }
  return {};
}

/// Ends the subscription, and waits for the callback where roscpp does not: it forgets the callback when the node shuts down.
template <class ImplPtr>
struct WaitingEnd {
  ImplPtr impl;
  WaitingMessages waiting;

  template <class Impl>
  void operator()(Impl*) {
    impl.reset();
    const auto queue = waiting.queue.lock();
    if (!queue) return;  // a call has it, so none runs
    queue->clear();      // under the mutex that a running callback has
    ConcurrentCall::wait_for_end(waiting.id);
  }
};

}  // namespace

ros::Subscriber with_waiting_end(ros::Subscriber subscriber, const ros::SubscribeOptions& options) {
  if (!subscriber || options.callback_queue != direct_dispatch_queue() || !is_roscpp_known())
    return subscriber;
  auto& impl = access::impl_(subscriber);
  using ImplPtr = std::decay_t<decltype(impl)>;
  WaitingEnd<ImplPtr> end{impl, queue_of(subscriber.getTopic(), options.helper)};
  auto* const same = impl.get();
  impl = ImplPtr(same, std::move(end));
  return subscriber;
}

}  // namespace detail
}  // namespace tzc
