// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/plain_attachment.h"

#include <ros/publication.h>
#include <ros/topic_manager.h>

#include "roscpp/configuration.h"
#include "roscpp/publish/connect_hook.h"
#include "roscpp/publish/publication_endpoint.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/runtime.h"

namespace tzc {
namespace detail {
namespace {

/// State that the hooked callback shares with its copies. Used on the clerk's thread, except for construction
/// and destruction.
class PlainAttachment {
 public:
  PlainAttachment(std::string topic, const MessageCodec& codec) : topic_(std::move(topic)), codec_(codec) {}

  /// A subscriber of this process says nothing about the topic, and comes before a ported program has attached it in its own way.
  void on_connect(const ros::SubscriberLinkPtr& link) {
    if (link->isIntraprocess()) return;
    if (!endpoint_) endpoint_ = make_endpoint();
    if (!endpoint_) return;
    endpoint_->on_connect(ros::SingleSubscriberPublisher(link));
    runtime().statistics.begin();
  }

 private:
  std::shared_ptr<PublicationEndpoint> make_endpoint() const {
    const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic_);
    if (!publication || publication->getMD5Sum() != codec_.md5sum) return nullptr;
    const std::shared_ptr<PublicationEndpoint> endpoint = PublicationEndpoint::of(
        publication, configured(PublisherOptions(), topic_), runtime().worker, runtime().peers);
    if (!endpoint) return nullptr;
    MessageCodec codec = codec_;
    codec.has_header = roscpp_access::has_header_(*publication);
    endpoint->records().codecs().add(codec);
    return endpoint;
  }

  const std::string topic_;
  const MessageCodec codec_;
  std::shared_ptr<PublicationEndpoint> endpoint_;
};

}  // namespace

void hook_advertisement(const std::string& resolved_topic, const MessageCodec& codec,
                        ros::AdvertiseOptions& options) {
  const bool is_ours = options.callback_queue == &runtime().queue;  // what TZC advertises beside the program
  if (is_ours || !is_enabled(resolved_topic)) return;
  const auto attachment = std::make_shared<PlainAttachment>(resolved_topic, codec);
  hook(resolved_topic, options,
       [attachment](const ros::SubscriberLinkPtr& link) { attachment->on_connect(link); });
}

}  // namespace detail
}  // namespace tzc
