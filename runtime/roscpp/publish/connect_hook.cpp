// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/connect_hook.h"

#include <ros/callback_queue_interface.h>
#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/topic_manager.h>
#include <tzc/detail/attachment.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "roscpp/roscpp_access.h"
#include "roscpp/runtime.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

bool has_queue(ros::Publication& publication, const ros::CallbackQueueInterface* queue) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(publication));
  const std::vector<ros::SubscriberCallbacksPtr>& all = access::callbacks_(publication);
  return std::any_of(all.begin(), all.end(), [&](const ros::SubscriberCallbacksPtr& callbacks) {
    return callbacks->callback_queue_ == queue;
  });
}

/// Tells of each link of a publication once. The clerk's thread only, but for construction.
class NewLinks {
 public:
  NewLinks(const ros::PublicationPtr& publication, OnSubscriber on_subscriber)
      : publication_(publication), is_found_(true), on_subscriber_(std::move(on_subscriber)) {}
  /// Of one that is yet to be made.
  NewLinks(std::string resolved_topic, OnSubscriber on_subscriber)
      : topic_(std::move(resolved_topic)), on_subscriber_(std::move(on_subscriber)) {}

  /// `queue`: of the callbacks of an advertisement, by which the publication is known.
  void tell(const ros::CallbackQueueInterface* queue) {
    const ros::PublicationPtr publication = find(queue);
    if (!publication) return;
    for (const ros::SubscriberLinkPtr& link : links_of(*publication))
      if (is_new(link)) on_subscriber_(link);
  }

 private:
  /// Of the topic's name there may be another one, which the program advertises anew just then.
  ros::PublicationPtr find(const ros::CallbackQueueInterface* queue) {
    if (is_found_) return publication_.lock();
    const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic_);
    if (!publication || !has_queue(*publication, queue)) return nullptr;
    publication_ = publication;
    is_found_ = true;
    return publication;
  }

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
  const std::string topic_;
  ros::PublicationWPtr publication_;
  bool is_found_ = false;
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
    runtime().clerk.post([links = links_, queue = this] { links->tell(queue); });
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
  const void* owner = nullptr;
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

void hook_one(const ros::PublicationWPtr& publication, const void* owner, const OnSubscriber& on_subscriber);

/// A connect callback has it as long as its advertisement lives. Then another advertisement gets one.
class Keeper {
 public:
  Keeper(const ros::PublicationPtr& publication, const void* owner, const OnSubscriber& on_subscriber)
      : publication_(publication), owner_(owner), on_subscriber_(on_subscriber) {}
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper() {
    if (!on_subscriber_) return;
    runtime().clerk.post([publication = publication_, owner = owner_, on_subscriber = on_subscriber_] {
      hook_one(publication, owner, on_subscriber);
    });
  }

  void on_subscriber(const ros::SubscriberLinkPtr& link) const { on_subscriber_(link); }
  /// There is no other one.
  void give_up() { on_subscriber_ = nullptr; }

 private:
  const ros::PublicationWPtr publication_;
  const void* const owner_;
  OnSubscriber on_subscriber_;
};

/// The caller has callbacks_mutex_.
bool any_has(const std::vector<ros::SubscriberCallbacksPtr>& all, const void* owner) {
  return std::any_of(all.begin(), all.end(), [&](const ros::SubscriberCallbacksPtr& callbacks) {
    const auto* const keeping = callbacks->connect_.target<KeepingQueue>();
    return keeping != nullptr && keeping->owner == owner;
  });
}

/// Puts a queue before the callbacks of the first advertisement. False: there is none, or one has it. roscpp reads the callbacks under the same
/// mutex, whenever a subscriber comes or goes.
bool put_before_first(ros::Publication& publication, const void* owner,
                      const std::shared_ptr<NewLinks>& links) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(publication));
  const std::vector<ros::SubscriberCallbacksPtr>& all = access::callbacks_(publication);
  if (all.empty() || any_has(all, owner)) return false;
  ros::SubscriberCallbacks& first = *all.front();
  const auto queue =
      std::make_shared<EarlyQueue>(queue_of(first.connect_, first.disconnect_, first.callback_queue_), links);
  first.connect_ = KeepingQueue{on_current_link(first.connect_), queue, owner};
  first.callback_queue_ = queue.get();
  return true;
}

/// The clerk's thread.
void hook_one(const ros::PublicationWPtr& weak, const void* owner, const OnSubscriber& on_subscriber) {
  const ros::PublicationPtr publication = weak.lock();
  if (!publication) return;
  const auto keeper = std::make_shared<Keeper>(publication, owner, on_subscriber);
  const auto links = std::make_shared<NewLinks>(
      publication, [keeper](const ros::SubscriberLinkPtr& link) { keeper->on_subscriber(link); });
  if (put_before_first(*publication, owner, links))
    links->tell(nullptr);
  else
    keeper->give_up();
}

}  // namespace

void hook(const std::string& resolved_topic, ros::AdvertiseOptions& options,
          const OnSubscriber& on_subscriber) {
  const auto queue = std::make_shared<EarlyQueue>(
      queue_of(options.connect_cb, options.disconnect_cb, options.callback_queue),
      std::make_shared<NewLinks>(resolved_topic, on_subscriber));
  options.connect_cb = KeepingQueue{on_current_link(options.connect_cb), queue, nullptr};
  options.callback_queue = queue.get();
}

void hook(const ros::PublicationPtr& publication, const void* owner, const OnSubscriber& on_subscriber) {
  runtime().clerk.post([weak = ros::PublicationWPtr(publication), owner, on_subscriber] {
    hook_one(weak, owner, on_subscriber);
  });
}

bool is_hooked(ros::Publication& publication, const void* owner) {
  const boost::mutex::scoped_try_lock lock(access::callbacks_mutex_(publication));
  return !lock || any_has(access::callbacks_(publication), owner);
}

}  // namespace detail
}  // namespace tzc
