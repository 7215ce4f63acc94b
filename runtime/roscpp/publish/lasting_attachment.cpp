// SPDX-License-Identifier: BSD-3-Clause
// Attachments that nobody keeps: they live as long as an advertisement of other code, whose connect callback owns them.

#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/topic_manager.h>
#include <tzc/detail/attachment.h>

#include <map>
#include <mutex>

#include "roscpp/publish/connect_hook.h"
#include "roscpp/publish/publication_endpoint.h"
#include "roscpp/runtime.h"

namespace tzc {
namespace detail {
namespace {

struct Known {
  ros::PublicationWPtr publication;
  boost::weak_ptr<ros::SubscriberCallbacks> owner;  ///< the callbacks that own the attachment
  std::weak_ptr<Attachment> attachment;
  bool is_settled = false;  ///< one is being made, or there will be none
};

/// By topic. Its lock is an inner one of any other, since a thread that publishes may hold roscpp's.
class KnownPublications {
 public:
  /// The attachment of a publication; null: it has none. `is_mine`: the caller is to make it, or to find it another owner, and
  /// everybody else goes on with what there is until then.
  std::shared_ptr<Attachment> find(const ros::PublicationPtr& publication, bool& is_mine) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Known& known = known_[publication->getName()];
    if (known.publication.lock() != publication) known = Known{publication, {}, {}, false};
    std::shared_ptr<Attachment> attachment = known.attachment.lock();
    is_mine = !known.is_settled && !(attachment && has_callbacks(*publication, known.owner.lock()));
    if (is_mine) known.is_settled = true;
    return attachment;
  }

  /// An attachment of null: the publication stays as it is. An owner of null: the next call is to find one.
  void made(const ros::PublicationPtr& publication, const std::shared_ptr<Attachment>& attachment,
            const ros::SubscriberCallbacksPtr& owner) {
    const std::lock_guard<std::mutex> lock(mutex_);
    known_[publication->getName()] = Known{publication, owner, attachment, !attachment};
    for (auto it = known_.begin(); it != known_.end();)
      it = it->second.publication.expired() ? known_.erase(it) : std::next(it);
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Known> known_;
};

KnownPublications& known_publications() {
  static auto* const instance = new KnownPublications;  // outlives every publication
  return *instance;
}

}  // namespace

// The connect callback owns the attachment, so that it ends with the advertisement; nothing of it leads back to the callback.
std::shared_ptr<Attachment> Attachment::lasting(const std::string& topic, const char* md5sum,
                                                MessageCodec (*codec)()) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  if (!publication || publication->getMD5Sum() != md5sum) return nullptr;
  bool is_mine = false;
  std::shared_ptr<Attachment> attachment = known_publications().find(publication, is_mine);
  if (!is_mine) return attachment;
  if (!attachment) attachment = to(publication, codec(), PublisherOptions());
  ros::SubscriberCallbacksPtr owner;
  if (attachment)
    owner = hook(publication, [attachment](const ros::SubscriberLinkPtr& link) {
      attachment->endpoint_->on_connect(ros::SingleSubscriberPublisher(link));
      runtime().statistics.begin();
    });
  known_publications().made(publication, attachment, owner);
  return attachment;
}

}  // namespace detail
}  // namespace tzc
