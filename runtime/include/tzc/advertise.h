// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <tzc/publisher.h>

#include <string>

namespace tzc {

namespace detail {
/// Clouds and their like are published by pointer as they are, beside the stock type that they stand for.
template <class M>
void add_foreign_codec(Attachment& attachment, std::true_type) {
  attachment.add_codec(make_codec<M>());
}
template <class M>
void add_foreign_codec(Attachment&, std::false_type) {}

/// As ros::NodeHandle::advertise<M> makes them, with the stock type for a tzc:: one. Whether header.seq is
/// counted is M's own affair: roscpp leaves it alone in a pcl::PointCloud.
template <class M>
ros::AdvertiseOptions advertise_options(
    const std::string& topic, std::uint32_t queue_size,
    const ros::SubscriberStatusCallback& connect_cb = ros::SubscriberStatusCallback(),
    const ros::SubscriberStatusCallback& disconnect_cb = ros::SubscriberStatusCallback()) {
  ros::AdvertiseOptions options;
  options.init<typename message::StockOf<M>::type>(topic, queue_size, connect_cb, disconnect_cb);
  options.has_header = ros::message_traits::hasHeader<M>();
  return options;
}

/// How messages of the stock type travel on this topic, with header.seq counted or not, as for every other
/// link.
template <class M>
MessageCodec codec_for(const ros::AdvertiseOptions& options) {
  MessageCodec codec = make_codec<typename message::StockOf<M>::type>();
  codec.has_header = options.has_header;
  return codec;
}
}  // namespace detail

/// Advertises `options` through roscpp and attaches shared memory to it. The forms below are shorthands for
/// this one. M: the tzc:: message type, or the stock type where only stock messages are published. Errors are
/// roscpp's own (exceptions for bad names, an empty publisher for a conflicting type).
template <class M>
Publisher advertise(ros::NodeHandle& node, ros::AdvertiseOptions& options,
                    const PublisherOptions& publisher_options) {
  ros::Publisher publisher = node.advertise(options);
  std::shared_ptr<detail::Attachment> attachment;
  if (publisher)
    attachment = detail::Attachment::create(node, options, detail::codec_for<M>(options), publisher_options);
  if (attachment) detail::add_foreign_codec<M>(*attachment, typename detail::IsForeign<M>::type());
  return Publisher(publisher, attachment);
}

/// As above, with `memory_size` bytes of shared memory (0: sized by queue and message).
template <class M>
Publisher advertise(ros::NodeHandle& node, ros::AdvertiseOptions& options, std::size_t memory_size = 0) {
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  return advertise<M>(node, options, publisher_options);
}

/// ros::NodeHandle::advertise(topic, queue_size, latch) with the size of the shared memory in between.
template <class M>
Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                    std::size_t memory_size = 0, bool latch = false) {
  ros::AdvertiseOptions options = detail::advertise_options<M>(topic, queue_size);
  options.latch = latch;
  return advertise<M>(node, options, memory_size);
}

/// ros::NodeHandle::advertise with connect callbacks.
template <class M>
Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                    std::size_t memory_size, const ros::SubscriberStatusCallback& connect_cb,
                    const ros::SubscriberStatusCallback& disconnect_cb = ros::SubscriberStatusCallback(),
                    const ros::VoidConstPtr& tracked_object = ros::VoidConstPtr(), bool latch = false) {
  ros::AdvertiseOptions options = detail::advertise_options<M>(topic, queue_size, connect_cb, disconnect_cb);
  options.tracked_object = tracked_object;
  options.latch = latch;
  return advertise<M>(node, options, memory_size);
}

/// Attaches shared memory to the topic of a publisher that other code advertised: a base class of a library,
/// for example, which may keep a copy of it. M: as for advertise. When the topic carries another type, the
/// publisher goes on as it was.
template <class M>
Publisher attach_publisher(const ros::Publisher& publisher, std::size_t memory_size = 0) {
  if (!publisher) return Publisher(publisher, nullptr);
  const ros::AdvertiseOptions options = detail::advertise_options<M>(publisher.getTopic(), 1);
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  const std::shared_ptr<detail::Attachment> attachment =
      detail::Attachment::join(options, detail::codec_for<M>(options), publisher_options);
  if (attachment) detail::add_foreign_codec<M>(*attachment, typename detail::IsForeign<M>::type());
  return Publisher(publisher, attachment);
}

/// Every form also for a temporary node handle (`tzc::advertise<M>(getNodeHandle(), ...)`).
template <class M, class... Args>
Publisher advertise(ros::NodeHandle&& node, Args&&... args) {
  return advertise<M>(static_cast<ros::NodeHandle&>(node), std::forward<Args>(args)...);
}

}  // namespace tzc
