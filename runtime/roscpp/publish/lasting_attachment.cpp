// SPDX-License-Identifier: BSD-3-Clause
// Attachments that nobody keeps: they live as long as an advertisement of other code, whose connect callback owns them.

#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/topic_manager.h>
#include <tzc/detail/attachment.h>

#include <chrono>
#include <map>
#include <mutex>

#include "roscpp/publish/connect_hook.h"
#include "roscpp/publish/publication_endpoint.h"
#include "roscpp/runtime.h"

namespace tzc {
namespace detail {
namespace {

using Clock = std::chrono::steady_clock;

struct Known {
  ros::PublicationWPtr publication;
  std::weak_ptr<Attachment> attachment;
  Clock::time_point not_before;  ///< when one may be made again
};

/// By topic. Its lock is an inner one of any other, since a thread that publishes may hold roscpp's.
class KnownPublications {
 public:
  /// The attachment of a publication; null: it has none. `is_mine`: the caller is to make it, and to call made() whatever comes of it;
  /// until then everybody else goes on without.
  std::shared_ptr<Attachment> find(const ros::PublicationPtr& publication, bool& is_mine) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Known& known = known_[publication->getName()];
    if (known.publication.lock() != publication) known = Known{publication, {}, {}};
    std::shared_ptr<Attachment> attachment = known.attachment.lock();
    is_mine = !attachment && known.not_before <= Clock::now();
    if (is_mine) known.not_before = Clock::time_point::max();
    return attachment;
  }

  /// Null: TZC is off for the topic, or lacks something for the moment.
  void made(const ros::PublicationPtr& publication, const std::shared_ptr<Attachment>& attachment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Known& known = known_[publication->getName()];
    known.attachment = attachment;
    known.not_before = attachment ? Clock::time_point() : Clock::now() + std::chrono::seconds(5);
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

/// Calls made() when it ends, also by an exception.
struct Making {
  explicit Making(const ros::PublicationPtr& of) : publication(of) {}
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;
  ~Making() { known_publications().made(publication, attachment); }

  const ros::PublicationPtr& publication;
  std::shared_ptr<Attachment> attachment;
};

}  // namespace

// The connect callback owns the attachment, so that it ends with the last advertisement; nothing of it leads back to the callback.
std::shared_ptr<Attachment> Attachment::lasting(const std::string& topic, const char* md5sum,
                                                MessageCodec (*codec)()) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  if (!publication || publication->getMD5Sum() != md5sum) return nullptr;
  bool is_mine = false;
  const auto invite_subscribers = [&publication](const std::shared_ptr<Attachment>& attachment) {
    hook(publication, attachment.get(), [attachment](const ros::SubscriberLinkPtr& link) {
      attachment->endpoint_->on_connect(ros::SingleSubscriberPublisher(link));
      runtime().statistics.begin();
    });
  };
  if (const auto known = known_publications().find(publication, is_mine)) {
    if (!is_hooked(*publication, known.get())) invite_subscribers(known);
    return known;
  }
  if (!is_mine) return nullptr;
  Making making(publication);
  const std::shared_ptr<Attachment> attachment = to(publication, codec(), PublisherOptions());
  if (attachment) invite_subscribers(attachment);
  return making.attachment = attachment;
}

}  // namespace detail
}  // namespace tzc
