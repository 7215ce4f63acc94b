// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/connect_hook.h"

#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <tzc/detail/attachment.h>

#include <algorithm>
#include <vector>

#include "roscpp/roscpp_access.h"
#include "roscpp/runtime.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

void on_clerk(const OnSubscriber& on_subscriber, const ros::SubscriberLinkPtr& link) {
  runtime().clerk.post([on_subscriber, link] { on_subscriber(link); });
}

ros::SubscriberStatusCallback before(const ros::SubscriberStatusCallback& users,
                                     const OnSubscriber& on_subscriber) {
  return [on_subscriber, users = on_current_link(users)](const ros::SingleSubscriberPublisher& subscriber) {
    on_clerk(on_subscriber, access::link_(const_cast<ros::SingleSubscriberPublisher&>(subscriber)));
    if (users) users(subscriber);
  };
}

/// The queue on which the callbacks run. A node without callbacks of its own may not spin the one that it named.
ros::CallbackQueueInterface* queue_of(const ros::SubscriberStatusCallback& connect,
                                      const ros::SubscriberStatusCallback& disconnect,
                                      ros::CallbackQueueInterface* named) {
  return connect || disconnect ? named : &runtime().queue;
}

}  // namespace

void hook(ros::AdvertiseOptions& options, const OnSubscriber& on_subscriber) {
  options.callback_queue = queue_of(options.connect_cb, options.disconnect_cb, options.callback_queue);
  options.connect_cb = before(options.connect_cb, on_subscriber);
}

// roscpp reads the callbacks under the same mutex, whenever a subscriber comes or goes. It holds it while it queues one, and a queue that
// calls at once may lead here.
ros::SubscriberCallbacksPtr hook(ros::Publication& publication, const OnSubscriber& on_subscriber) {
  ros::SubscriberCallbacksPtr first;
  {
    const boost::mutex::scoped_try_lock lock(access::callbacks_mutex_(publication));
    if (!lock || access::callbacks_(publication).empty()) return nullptr;
    first = access::callbacks_(publication).front();
    first->callback_queue_ = queue_of(first->connect_, first->disconnect_, first->callback_queue_);
    first->connect_ = before(first->connect_, on_subscriber);
  }
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
  for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(publication))
    on_clerk(on_subscriber, link);
  return first;
}

bool has_callbacks(ros::Publication& publication, const ros::SubscriberCallbacksPtr& callbacks) {
  const boost::mutex::scoped_try_lock lock(access::callbacks_mutex_(publication));
  if (!lock) return true;
  const std::vector<ros::SubscriberCallbacksPtr>& all = access::callbacks_(publication);
  return std::find(all.begin(), all.end(), callbacks) != all.end();
}

}  // namespace detail
}  // namespace tzc
