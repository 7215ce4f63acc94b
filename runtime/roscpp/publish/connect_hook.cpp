// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/connect_hook.h"

#include <ros/callback_queue_interface.h>
#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <tzc/detail/attachment.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
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

/// Tells of each link of a publication once.
class NewLinks {
 public:
  NewLinks(const ros::PublicationPtr& publication, OnSubscriber on_subscriber)
      : publication_(publication), on_subscriber_(std::move(on_subscriber)) {}

  /// The clerk's thread only.
  void tell() {
    const ros::PublicationPtr publication = publication_.lock();
    if (!publication) return;
    for (const ros::SubscriberLinkPtr& link : links_of(*publication))
      if (is_new(link)) on_subscriber_(link);
  }

 private:
  static ros::V_SubscriberLink links_of(ros::Publication& publication) {
    const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
    return access::subscriber_links_(publication);
  }

  bool is_new(const ros::SubscriberLinkPtr& link) {
    told_.erase(std::remove_if(told_.begin(), told_.end(), [](const Link& one) { return one.expired(); }),
                told_.end());
    if (std::any_of(told_.begin(), told_.end(), [&](const Link& one) { return one.lock() == link; }))
      return false;
    told_.emplace_back(link);
    return true;
  }

  using Link = boost::weak_ptr<ros::SubscriberLink>;
  const ros::PublicationWPtr publication_;
  const OnSubscriber on_subscriber_;
  std::vector<Link> told_;
};

/// Stands before the queue of an advertisement's callbacks, on which they run when the program has time for them, or never: a camera that
/// publishes with image_transport, whose callbacks these are, need not spin.
class EarlyQueue : public ros::CallbackQueueInterface {
 public:
  EarlyQueue(ros::CallbackQueueInterface* queue, std::shared_ptr<NewLinks> links)
      : queue_(queue), links_(std::move(links)) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    runtime().clerk.post([links = links_] { links->tell(); });
    queue_->addCallback(callback, owner);
  }
  void removeByID(std::uint64_t owner) override { queue_->removeByID(owner); }

 private:
  ros::CallbackQueueInterface* const queue_;
  const std::shared_ptr<NewLinks> links_;
};

/// Does what another callback does, and keeps the queue that its advertisement points to.
struct KeepingQueue {
  ros::SubscriberStatusCallback callback;
  std::shared_ptr<EarlyQueue> queue;
  void operator()(const ros::SingleSubscriberPublisher& subscriber) const {
    if (callback) callback(subscriber);
  }
};

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
ros::SubscriberCallbacksPtr hook(const ros::PublicationPtr& publication, const OnSubscriber& on_subscriber) {
  const auto links = std::make_shared<NewLinks>(publication, on_subscriber);
  ros::SubscriberCallbacksPtr first;
  {
    const boost::mutex::scoped_try_lock lock(access::callbacks_mutex_(*publication));
    if (!lock || access::callbacks_(*publication).empty()) return nullptr;
    first = access::callbacks_(*publication).front();
    const auto queue = std::make_shared<EarlyQueue>(
        queue_of(first->connect_, first->disconnect_, first->callback_queue_), links);
    first->connect_ = KeepingQueue{on_current_link(first->connect_), queue};
    first->callback_queue_ = queue.get();
  }
  runtime().clerk.post([links] { links->tell(); });
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
