// SPDX-License-Identifier: BSD-3-Clause
// Attachments to what other code advertises: they live as long as that does, since its connect callback owns them.

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

/// Who asks for an attachment: one who publishes with what there is, and asks again with the next message, or one who keeps it.
enum class Asker { message, publisher };

struct Known {
  ros::PublicationWPtr publication;
  std::weak_ptr<Attachment> attachment;
  bool is_being_made = false;
  Clock::time_point not_before;  ///< when a message may make one again
};

/// By topic. Its lock is an inner one of any other, since a thread that publishes may hold roscpp's.
class KnownPublications {
 public:
  /// The attachment of a publication; null: it has none. `is_mine`: the caller is to make it, and to call made() whatever comes of it;
  /// until then everybody else goes on without.
  std::shared_ptr<Attachment> find(const ros::PublicationPtr& publication, Asker asker, bool& is_mine) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Known& known = known_[publication->getName()];
    if (known.publication.lock() != publication) {
      known = Known();
      known.publication = publication;
    }
    std::shared_ptr<Attachment> attachment = known.attachment.lock();
    is_mine = !attachment && !known.is_being_made &&
              (asker == Asker::publisher || known.not_before <= Clock::now());
    if (is_mine) known.is_being_made = true;
    return attachment;
  }

  /// Null: TZC is off for the topic, or lacks something for the moment.
  void made(const ros::PublicationPtr& publication, const std::shared_ptr<Attachment>& attachment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Known& known = known_[publication->getName()];
    if (known.publication.lock() == publication) {  // no other one has taken its place meanwhile
      known.attachment = attachment;
      known.is_being_made = false;
      if (!attachment) known.not_before = Clock::now() + std::chrono::seconds(5);
    }
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

/// Null: the topic is not advertised, or carries another type.
ros::PublicationPtr publication_of(const std::string& topic, const char* md5sum) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  return publication && publication->getMD5Sum() == md5sum ? publication : nullptr;
}

}  // namespace

// Nothing of the attachment leads back to the callback, so that it ends with the last advertisement.
void Attachment::hand_over(const ros::PublicationPtr& publication,
                           const std::shared_ptr<Attachment>& attachment) {
  hook(publication, attachment.get(), [attachment](const ros::SubscriberLinkPtr& link) {
    attachment->endpoint_->on_connect(ros::SingleSubscriberPublisher(link));
    runtime().statistics.begin();
  });
}

std::shared_ptr<Attachment> Attachment::make_lasting(const ros::PublicationPtr& publication,
                                                     const MessageCodec& codec,
                                                     const PublisherOptions& options) {
  Making making(publication);
  making.attachment = to(publication, codec, options);
  if (making.attachment) hand_over(publication, making.attachment);
  return making.attachment;
}

std::shared_ptr<Attachment> Attachment::lasting(const std::string& topic, const char* md5sum,
                                                MessageCodec (*codec)()) {
  const ros::PublicationPtr publication = publication_of(topic, md5sum);
  if (!publication) return nullptr;
  bool is_mine = false;
  if (const auto known = known_publications().find(publication, Asker::message, is_mine)) {
    if (!is_hooked(*publication, known.get())) hand_over(publication, known);
    return known;
  }
  return is_mine ? make_lasting(publication, codec(), PublisherOptions()) : nullptr;
}

std::shared_ptr<Attachment> Attachment::join(const std::string& topic, const char* md5sum,
                                             MessageCodec (*codec)(), const PublisherOptions& options) {
  const ros::PublicationPtr publication = publication_of(topic, md5sum);
  if (!publication) return nullptr;
  bool is_mine = false;
  if (const auto known = known_publications().find(publication, Asker::publisher, is_mine)) {
    hand_over(publication, known);
    return known;
  }
  // The thread that makes the other one makes both known to subscribers: they share the topic's endpoint.
  return is_mine ? make_lasting(publication, codec(), options) : to(publication, codec(), options);
}

}  // namespace detail
}  // namespace tzc
