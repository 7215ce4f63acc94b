// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/detail/attachment.h>

#include <ros/publication.h>
#include <ros/topic_manager.h>

#include "roscpp/configuration.h"
#include "roscpp/publish/publication_endpoint.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/runtime.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

/// Advertises the topic once more, only for TZC's connect callback, on the transport's own queue. roscpp
/// calls it for existing subscribers, too. Ends with `tracked`.
ros::Publisher observe(ros::NodeHandle& node, const ros::AdvertiseOptions& options,
                       const std::shared_ptr<PublicationEndpoint>& endpoint) {
  const std::weak_ptr<PublicationEndpoint> weak = endpoint;
  ros::AdvertiseOptions observer(options.topic, options.queue_size, options.md5sum, options.datatype,
                                 options.message_definition,
                                 [weak](const ros::SingleSubscriberPublisher& subscriber) {
                                   if (const std::shared_ptr<PublicationEndpoint> alive = weak.lock())
                                     alive->on_connect(subscriber);
                                   runtime().statistics.begin();
                                 });
  observer.has_header = options.has_header;
  observer.callback_queue = &runtime().queue;
  return node.advertise(observer);
}

}  // namespace

std::shared_ptr<Attachment> Attachment::to(const ros::PublicationPtr& publication, const MessageCodec& codec,
                                           const PublisherOptions& publisher_options) {
  const std::string& topic = publication->getName();
  if (is_left_out(topic))
    runtime().statistics.add_plain(publication, "the publisher's ~tzc/disable_topics names this topic");
  if (!is_enabled(topic)) return nullptr;
  bind_again();
  std::shared_ptr<Attachment> attachment(new Attachment);
  attachment->endpoint_ = PublicationEndpoint::of(publication, configured(publisher_options, topic),
                                                  runtime().worker, runtime().peers);
  if (!attachment->endpoint_) return nullptr;
  attachment->has_header_ = roscpp_access::has_header_(*publication);
  attachment->add_codec(codec);
  return attachment;
}

std::shared_ptr<Attachment> Attachment::create(ros::NodeHandle& node, const ros::AdvertiseOptions& options,
                                               const MessageCodec& codec,
                                               const PublisherOptions& publisher_options) {
  const ros::PublicationPtr publication =
      ros::TopicManager::instance()->lookupPublication(node.resolveName(options.topic));
  if (!publication) return nullptr;
  const std::shared_ptr<Attachment> attachment = to(publication, codec, publisher_options);
  if (attachment) attachment->observer_ = observe(node, options, attachment->endpoint_);
  return attachment;
}

Attachment::~Attachment() {
  shutdown();
}

void Attachment::add_codec(MessageCodec codec) {
  codec.has_header = has_header_;
  endpoint_->records().codecs().add(codec);
}
bool Attachment::knows(const std::type_info& type) const {
  return endpoint_->records().codecs().has(type);
}

void Attachment::shutdown() {
  observer_.shutdown();
}

const std::shared_ptr<MemorySource>& Attachment::memory() const {
  return endpoint_->memory();
}
bool Attachment::wants_pointer(const std::type_info& type) const {
  return endpoint_->wants_pointer(type);
}
bool Attachment::publish_by_reference(const std::type_info& type,
                                      const std::function<void()>& publish) const {
  // A connection is upgraded under this mutex, which roscpp's publish takes too.
  const boost::recursive_mutex::scoped_lock lock(
      roscpp_access::advertised_topics_mutex_(*ros::TopicManager::instance()));
  if (wants_pointer(type)) return false;
  sync_point("publish: by reference");
  publish();
  return true;
}
void Attachment::send_queued() {
  endpoint_->send_queued();
}
void Attachment::publish_numbered(const std::type_info& type, message::Encoded& encoded, Others others,
                                  const std::function<void()>& publish) {
  endpoint_->publish_numbered(type, encoded, others, publish);
}
bool Attachment::publish_directly(const std::type_info& type, message::Encoded& encoded) {
  return endpoint_->publish_directly(type, encoded);
}
LocalMessage Attachment::local_message(const std::type_info& type, const message::Encoded& encoded) const {
  return endpoint_->local_message(type, encoded);
}
bool Attachment::delivers_exhausted() const {
  return endpoint_->on_exhausted() == OnExhausted::deliver;
}
void Attachment::count_dropped(std::size_t bytes) {
  endpoint_->records().drops_without_memory([bytes] { return bytes; });
}
PublisherStatistics Attachment::statistics() const {
  return endpoint_->statistics();
}

void attach_topic(const std::string& resolved_topic, const MessageCodec& codec) {
  if (is_enabled(resolved_topic)) runtime().responder.attach(resolved_topic, codec, bind_again());
}

}  // namespace detail
}  // namespace tzc
