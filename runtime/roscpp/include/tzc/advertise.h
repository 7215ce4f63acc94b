// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <tzc/publisher.h>

#include <memory>
#include <string>
#include <type_traits>

namespace tzc {

namespace detail {
/// Foreign types such as pcl::PointCloud are published by pointer as they are, besides the stock type that
/// they stand for.
template <class M>
void add_foreign_codec(Attachment& attachment, std::true_type) {
  attachment.add_codec(make_codec<M>());
}
template <class M>
void add_foreign_codec(Attachment&, std::false_type) {}

/// The options that ros::NodeHandle::advertise<M> makes, with the stock type for a tzc:: one. M decides
/// whether header.seq is counted: roscpp does not count it in a pcl::PointCloud.
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

/// The codec of the topic's stock type, with header.seq counted or not as on the topic's other links.
template <class M>
MessageCodec codec_for(const ros::AdvertiseOptions& options) {
  MessageCodec codec = make_codec<typename message::StockOf<M>::type>();
  codec.has_header = options.has_header;
  return codec;
}

template <class M>
std::shared_ptr<Attachment> with_foreign_codec(const std::shared_ptr<Attachment>& attachment) {
  if (attachment) add_foreign_codec<M>(*attachment, typename IsForeign<M>::type());
  return attachment;
}

/// Attaches shared memory to a publisher of M. Null for types without a partial form.
template <class M, bool = message::HasPartialForm<M>::value>
struct Attach {
  static std::shared_ptr<Attachment> create(ros::NodeHandle& node, const ros::AdvertiseOptions& options,
                                            const PublisherOptions& publisher_options) {
    return with_foreign_codec<M>(Attachment::create(node, options, codec_for<M>(options), publisher_options));
  }
};
template <class M>
struct Attach<M, false> {
  template <class... Arguments>
  static std::shared_ptr<Attachment> create(const Arguments&...) {
    return nullptr;
  }
};
}  // namespace detail

/// Advertises `options` through roscpp and attaches shared memory to it. The forms below are shorthands for
/// this one. M: the tzc:: message type, or the stock type if only stock messages are published. Errors are
/// roscpp's own (exceptions for bad names, an empty publisher for a conflicting type). A type without a
/// partial form (message::HasPartialForm) gets a plain publisher. Publishers of one topic in one process
/// share one memory; the first publisher's options apply to it.
template <class M>
Publisher advertise(ros::NodeHandle& node, ros::AdvertiseOptions& options,
                    const PublisherOptions& publisher_options) {
  const ros::AdvertiseOptions as_written = options;  // roscpp resolves the name in place, and remaps it once
  ros::AdvertiseOptions moving = options;            // the program may advertise with its own ones again
  moving.connect_cb = detail::on_current_link(options.connect_cb);
  const ros::Publisher publisher = node.advertise(moving);
  options.topic = moving.topic;
  options.callback_queue = moving.callback_queue;
  if (!publisher) return Publisher(publisher, nullptr);
  return Publisher(publisher, detail::Attach<M>::create(node, as_written, publisher_options));
}

/// As above, with `memory_size` bytes of shared memory (0: sized by queue and message).
template <class M>
Publisher advertise(ros::NodeHandle& node, ros::AdvertiseOptions& options, std::size_t memory_size = 0) {
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  return advertise<M>(node, options, publisher_options);
}

/// ros::NodeHandle::advertise(topic, queue_size, latch) with the publisher's own options before `latch`.
template <class M>
Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                    const PublisherOptions& publisher_options, bool latch = false) {
  ros::AdvertiseOptions options = detail::advertise_options<M>(topic, queue_size);
  options.latch = latch;
  return advertise<M>(node, options, publisher_options);
}
/// The same with only the size of the shared memory, in bytes.
template <class M>
Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                    std::size_t memory_size = 0, bool latch = false) {
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  return advertise<M>(node, topic, queue_size, publisher_options, latch);
}
/// The arguments of ros::NodeHandle::advertise, unchanged. Only a bool is taken for `latch`, and a bool is never
/// taken for a memory size.
template <class M, class Bool>
typename std::enable_if<std::is_same<Bool, bool>::value, Publisher>::type advertise(ros::NodeHandle& node,
                                                                                    const std::string& topic,
                                                                                    std::uint32_t queue_size,
                                                                                    Bool latch) {
  return advertise<M>(node, topic, queue_size, PublisherOptions(), latch);
}

/// ros::NodeHandle::advertise with connect callbacks, behind the memory size.
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
/// The same with the arguments of ros::NodeHandle::advertise, unchanged.
template <class M>
Publisher advertise(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                    const ros::SubscriberStatusCallback& connect_cb,
                    const ros::SubscriberStatusCallback& disconnect_cb = ros::SubscriberStatusCallback(),
                    const ros::VoidConstPtr& tracked_object = ros::VoidConstPtr(), bool latch = false) {
  return advertise<M>(node, topic, queue_size, std::size_t(0), connect_cb, disconnect_cb, tracked_object,
                      latch);
}

/// Every form of advertise for a temporary node handle (`tzc::advertise<M>(getNodeHandle(), ...)`). By value, as the sizes that it
/// takes: a reference to a `static const int` of a class would need its definition.
template <class M, class... Args>
Publisher advertise(ros::NodeHandle&& node, Args... args) {
  return advertise<M>(static_cast<ros::NodeHandle&>(node), args...);
}

}  // namespace tzc
