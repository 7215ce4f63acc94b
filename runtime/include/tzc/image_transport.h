// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tzc/detail/shared_message.h>
#include <tzc/publisher.h>
#include <tzc/subscribe.h>

#include <memory>
#include <string>
#include <utility>

namespace tzc {
namespace image_transport {

namespace detail {

/// Shared memory beside the raw transport of `topic`. The compressed transports read the same message.
inline std::shared_ptr<::tzc::detail::Attachment> attach_raw(const std::string& topic, std::size_t memory_size) {
  ros::AdvertiseOptions options;
  options.init<::sensor_msgs::Image>(topic, 1);
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  ros::NodeHandle node;
  return ::tzc::detail::Attachment::create(node, options, ::tzc::detail::make_codec<::sensor_msgs::Image>(),
                                           publisher_options);
}

/// What both kinds of image publishers share. Stock: the image_transport publisher that does the work.
template <class Stock>
class PublisherBase {
 public:
  PublisherBase() {}
  PublisherBase(const Stock& publisher, std::size_t memory_size) : publisher_(publisher) {
    if (publisher_) attachment_ = attach_raw(publisher_.getTopic(), memory_size);
  }

  /// Binds the image's array to this publisher's shared memory, as tzc::Publisher::allocate.
  template <class M>
  bool allocate(M& message) const {
    return attachment_ && message::allocate(message, attachment_->memory());
  }
  template <class M>
  bool allocate(const boost::shared_ptr<M>& message) const {
    return allocate(*message);
  }
  /// The shared memory behind this publisher; null when TZC is off or the publisher is not advertised.
  std::shared_ptr<MemorySource> memory() const {
    return attachment_ ? attachment_->memory() : std::shared_ptr<MemorySource>();
  }
  PublisherStatistics statistics() const {
    return attachment_ ? attachment_->statistics() : PublisherStatistics();
  }

  /// \name As in the stock publisher
  /// @{
  std::uint32_t getNumSubscribers() const { return publisher_.getNumSubscribers(); }
  std::string getTopic() const { return publisher_.getTopic(); }
  void shutdown() {
    attachment_.reset();
    publisher_.shutdown();
  }
  operator void*() const { return publisher_; }
  bool operator<(const PublisherBase& rhs) const { return publisher_ < rhs.publisher_; }
  bool operator==(const PublisherBase& rhs) const { return publisher_ == rhs.publisher_; }
  bool operator!=(const PublisherBase& rhs) const { return publisher_ != rhs.publisher_; }
  /// @}

  /// The stock publisher, for interfaces that ask for one.
  const Stock& stock() const { return publisher_; }

 protected:
  /// A stock message by reference is worth a pointer only when somebody takes pointers.
  bool wants_pointer() const { return attachment_ && attachment_->wants_pointer(typeid(::sensor_msgs::Image)); }

  Stock publisher_;
  std::shared_ptr<::tzc::detail::Attachment> attachment_;
};

}  // namespace detail

/// A drop-in for image_transport::Publisher: the raw transport goes through shared memory, the others work as before.
class Publisher : public detail::PublisherBase<::image_transport::Publisher> {
 public:
  using detail::PublisherBase<::image_transport::Publisher>::PublisherBase;

  void publish(const ::sensor_msgs::ImageConstPtr& message) const { publisher_.publish(message); }
  void publish(const ::sensor_msgs::Image& message) const {
    if (!attachment_)
      publisher_.publish(message);
    else if (wants_pointer() || !attachment_->publish_by_reference(typeid(::sensor_msgs::Image),
                                                                   [&] { publisher_.publish(message); }))
      publish_twin(message);
  }
  /// A tzc::sensor_msgs::Image, by reference or pointer.
  template <class M>
  void publish(const M& message) const {
    publish_twin(message);
  }
  template <class M>
  void publish(const boost::shared_ptr<M>& message) const {
    publish_pointer(message);
  }

 private:
  template <class M>
  void publish_twin(const M& message) const {
    ::tzc::detail::publish_as_stock(attachment_.get(), message,
                                    [this](const ::sensor_msgs::ImageConstPtr& view) { publisher_.publish(view); });
  }
  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message) const {
    publish_twin(*message);
  }
  void publish_pointer(const ::sensor_msgs::ImagePtr& message) const { publisher_.publish(message); }
};

/// A drop-in for image_transport::CameraPublisher. The camera info is small and travels as before.
class CameraPublisher : public detail::PublisherBase<::image_transport::CameraPublisher> {
 public:
  using detail::PublisherBase<::image_transport::CameraPublisher>::PublisherBase;

  std::string getInfoTopic() const { return publisher_.getInfoTopic(); }

  void publish(const ::sensor_msgs::ImageConstPtr& image, const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publisher_.publish(image, info);
  }
  /// Image and info by reference; either may be its tzc:: type.
  template <class Image, class Info>
  void publish(const Image& image, const Info& info) const {
    const auto stock_info = boost::make_shared<::sensor_msgs::CameraInfo>(message::to_stock(info));
    publish_image(image, stock_info);
  }
  /// A tzc::sensor_msgs::Image by pointer, with the camera info by pointer.
  template <class Image, class Info>
  void publish(const boost::shared_ptr<Image>& image, const boost::shared_ptr<Info>& info) const {
    publish_image_pointer(image, stock_pointer(info));
  }
  /// Stamps both, as the stock publisher does.
  template <class Image, class Info>
  void publish(Image& image, Info& info, ros::Time stamp) const {
    image.header.stamp = stamp;
    info.header.stamp = stamp;
    publish(static_cast<const Image&>(image), static_cast<const Info&>(info));
  }

 private:
  template <class Image>
  void publish_image(const Image& image, const ::sensor_msgs::CameraInfoConstPtr& info) const {
    ::tzc::detail::publish_as_stock(
        attachment_.get(), image,
        [&](const ::sensor_msgs::ImageConstPtr& view) { publisher_.publish(view, info); });
  }
  template <class Image>
  void publish_image_pointer(const boost::shared_ptr<Image>& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publish_image(*image, info);
  }
  void publish_image_pointer(const ::sensor_msgs::ImagePtr& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publisher_.publish(image, info);
  }
  void publish_image_pointer(const ::sensor_msgs::ImageConstPtr& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publisher_.publish(image, info);
  }
  template <class Info>
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const boost::shared_ptr<Info>& info) {
    return boost::make_shared<::sensor_msgs::CameraInfo>(message::to_stock(*info));
  }
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const ::sensor_msgs::CameraInfoPtr& info) { return info; }
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const ::sensor_msgs::CameraInfoConstPtr& info) {
    return info;
  }
};

/// image_transport::ImageTransport::advertise in all its overloads, with shared memory sized by queue and image.
template <class... Args>
Publisher advertise(::image_transport::ImageTransport& transport, Args&&... args) {
  return Publisher(transport.advertise(std::forward<Args>(args)...), 0);
}
template <class... Args>
Publisher advertise(::image_transport::ImageTransport&& transport, Args&&... args) {
  return advertise(transport, std::forward<Args>(args)...);
}
/// image_transport::ImageTransport::advertiseCamera in all its overloads.
template <class... Args>
CameraPublisher advertiseCamera(::image_transport::ImageTransport& transport, Args&&... args) {
  return CameraPublisher(transport.advertiseCamera(std::forward<Args>(args)...), 0);
}
template <class... Args>
CameraPublisher advertiseCamera(::image_transport::ImageTransport&& transport, Args&&... args) {
  return advertiseCamera(transport, std::forward<Args>(args)...);
}

/// image_transport::ImageTransport::subscribe in all its overloads. Only the raw transport has something to share.
template <class... Args>
::image_transport::Subscriber subscribe(::image_transport::ImageTransport& transport, Args&&... args) {
  ::image_transport::Subscriber subscriber = transport.subscribe(std::forward<Args>(args)...);
  if (subscriber) attach<::sensor_msgs::Image>(subscriber.getTopic());
  return subscriber;
}
template <class... Args>
::image_transport::Subscriber subscribe(::image_transport::ImageTransport&& transport, Args&&... args) {
  return subscribe(transport, std::forward<Args>(args)...);
}
/// image_transport::ImageTransport::subscribeCamera in all its overloads.
template <class... Args>
::image_transport::CameraSubscriber subscribeCamera(::image_transport::ImageTransport& transport, Args&&... args) {
  ::image_transport::CameraSubscriber subscriber = transport.subscribeCamera(std::forward<Args>(args)...);
  if (subscriber) attach<::sensor_msgs::Image>(subscriber.getTopic());
  return subscriber;
}
template <class... Args>
::image_transport::CameraSubscriber subscribeCamera(::image_transport::ImageTransport&& transport, Args&&... args) {
  return subscribeCamera(transport, std::forward<Args>(args)...);
}

/// A drop-in for image_transport::SubscriberFilter.
class SubscriberFilter : public ::image_transport::SubscriberFilter {
 public:
  SubscriberFilter() {}
  SubscriberFilter(::image_transport::ImageTransport& transport, const std::string& base_topic,
                   std::uint32_t queue_size,
                   const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
    subscribe(transport, base_topic, queue_size, hints);
  }
  void subscribe(::image_transport::ImageTransport& transport, const std::string& base_topic,
                 std::uint32_t queue_size,
                 const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
    ::image_transport::SubscriberFilter::subscribe(transport, base_topic, queue_size, hints);
    attach<::sensor_msgs::Image>(getTopic());
  }
};

}  // namespace image_transport
}  // namespace tzc
