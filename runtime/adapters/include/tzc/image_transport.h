// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <image_transport/image_transport.h>
#include <image_transport/subscriber_filter.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tzc/attach.h>
#include <tzc/detail/publisher_base.h>
#include <tzc/detail/shared_message.h>
#include <tzc/subscribe.h>

#include <memory>
#include <string>

namespace tzc {
namespace image_transport {

namespace detail {

/// The topic of the raw transport, which resolves the name once more, as here.
template <class Stock>
std::string raw_topic(const Stock& publisher) {
  return ros::NodeHandle().resolveName(publisher.getTopic());
}

/// Base of both kinds of image publishers. Stock: the image_transport publisher that does the work.
template <class Stock>
class ImagePublisherBase : public ::tzc::detail::PublisherBase<Stock> {
 public:
  ImagePublisherBase() {}
  ImagePublisherBase(const Stock& publisher, std::size_t memory_size)
      : ::tzc::detail::PublisherBase<Stock>(publisher, attach(publisher, memory_size)) {}
  using ::tzc::detail::PublisherBase<Stock>::PublisherBase;

 protected:
  /// A subscriber takes images by pointer, so what is published by reference goes by pointer, too. Unlike PublisherBase's
  /// publish_by_reference this lets a subscriber begin with it meanwhile: to prevent that is to hold up all topics of the process
  /// while plugins compress. Whatever goes by pointer afterwards lets what waits in roscpp's queue go first.
  bool wants_pointer() const {
    return this->attachment_ && this->attachment_->wants_pointer(typeid(::sensor_msgs::Image));
  }
  void send_queued() const {
    if (this->attachment_) this->attachment_->send_queued();
  }

 private:
  /// Shared memory beside the raw transport. The compressed transports read the same message.
  static std::shared_ptr<::tzc::detail::Attachment> attach(const Stock& publisher, std::size_t memory_size) {
    if (!publisher) return nullptr;
    return ::tzc::detail::joined_attachment<::sensor_msgs::Image>(raw_topic(publisher), memory_size,
                                                                  std::true_type());
  }
};

}  // namespace detail

/// A drop-in for image_transport::Publisher: the raw transport goes through shared memory, the others work as
/// before.
class Publisher : public detail::ImagePublisherBase<::image_transport::Publisher> {
 public:
  using detail::ImagePublisherBase<::image_transport::Publisher>::ImagePublisherBase;

  void publish(const ::sensor_msgs::ImageConstPtr& message) const {
    send_queued();
    publisher_.publish(message);
  }
  void publish(const ::sensor_msgs::Image& message) const {
    if (wants_pointer())
      publish_twin(message, ByReference::yes);
    else
      publisher_.publish(message);
  }
  /// A tzc::sensor_msgs::Image, by reference or pointer.
  template <class M>
  void publish(const M& message) const {
    publish_twin(message, ByReference::yes);
  }
  template <class M>
  void publish(const boost::shared_ptr<M>& message) const {
    publish_pointer(message);
  }

 private:
  /// Without subscribers it copies and converts nothing, as the library's plugins do.
  template <class M>
  void publish_twin(const M& message, ByReference how) const {
    if (publisher_.getNumSubscribers() == 0) return;
    ::tzc::detail::publish_as_stock(
        attachment_.get(), message, how,
        [this](const ::sensor_msgs::ImageConstPtr& view) { publisher_.publish(view); });
  }
  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message) const {
    publish_twin(*message, ByReference::no);
  }
  void publish_pointer(const ::sensor_msgs::ImagePtr& message) const {
    publish(::sensor_msgs::ImageConstPtr(message));
  }
};

/// A drop-in for image_transport::CameraPublisher. The camera info is small and travels as before; an image that is dropped for want of
/// memory (on_exhausted) takes its info along.
class CameraPublisher : public detail::ImagePublisherBase<::image_transport::CameraPublisher> {
 public:
  using detail::ImagePublisherBase<::image_transport::CameraPublisher>::ImagePublisherBase;

  std::string getInfoTopic() const { return publisher_.getInfoTopic(); }

  void publish(const ::sensor_msgs::ImageConstPtr& image,
               const ::sensor_msgs::CameraInfoConstPtr& info) const {
    send_queued();
    publisher_.publish(image, info);
  }
  void publish(const ::sensor_msgs::Image& image, const ::sensor_msgs::CameraInfo& info) const {
    if (wants_pointer())
      publish_image(image, boost::make_shared<::sensor_msgs::CameraInfo>(info), ByReference::yes);
    else
      publisher_.publish(image, info);
  }
  /// Image and info by reference; either may be its tzc:: type.
  template <class Image, class Info>
  void publish(const Image& image, const Info& info) const {
    publish_image(image, message::make_stock(info), ByReference::yes);
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
  void publish_image(const Image& image, const ::sensor_msgs::CameraInfoConstPtr& info,
                     ByReference how) const {
    ::tzc::detail::publish_as_stock(
        attachment_.get(), image, how,
        [&](const ::sensor_msgs::ImageConstPtr& view) { publisher_.publish(view, info); });
  }
  template <class Image>
  void publish_image_pointer(const boost::shared_ptr<Image>& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publish_image(*image, info, ByReference::no);
  }
  void publish_image_pointer(const ::sensor_msgs::ImagePtr& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publish(::sensor_msgs::ImageConstPtr(image), info);
  }
  void publish_image_pointer(const ::sensor_msgs::ImageConstPtr& image,
                             const ::sensor_msgs::CameraInfoConstPtr& info) const {
    publish(image, info);
  }
  template <class Info>
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const boost::shared_ptr<Info>& info) {
    return message::make_stock(*info);
  }
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const ::sensor_msgs::CameraInfoPtr& info) {
    return info;
  }
  static ::sensor_msgs::CameraInfoConstPtr stock_pointer(const ::sensor_msgs::CameraInfoConstPtr& info) {
    return info;
  }
};

/// image_transport::ImageTransport::advertise in all its overloads, with shared memory sized by queue and
/// image. By value, as the sizes that it takes: a reference to a `static const int` of a class would need its definition.
template <class... Args>
Publisher advertise(::image_transport::ImageTransport& transport, Args... args) {
  return Publisher(transport.advertise(args...), 0);
}
template <class... Args>
Publisher advertise(::image_transport::ImageTransport&& transport, Args... args) {
  return Publisher(transport.advertise(args...), 0);
}
/// image_transport::ImageTransport::advertiseCamera in all its overloads.
template <class... Args>
CameraPublisher advertiseCamera(::image_transport::ImageTransport& transport, Args... args) {
  return CameraPublisher(transport.advertiseCamera(args...), 0);
}
template <class... Args>
CameraPublisher advertiseCamera(::image_transport::ImageTransport&& transport, Args... args) {
  return CameraPublisher(transport.advertiseCamera(args...), 0);
}

/// Attaches shared memory to an image publisher that other code advertised, for example a library's base
/// class that keeps a copy of it.
inline Publisher attach_publisher(const ::image_transport::Publisher& publisher,
                                  std::size_t memory_size = 0) {
  return Publisher(publisher, memory_size);
}
inline CameraPublisher attach_publisher(const ::image_transport::CameraPublisher& publisher,
                                        std::size_t memory_size = 0) {
  return CameraPublisher(publisher, memory_size);
}

namespace detail {

/// Of the raw transport, for as long as the program advertises the topic; null: TZC is off.
template <class Stock>
std::shared_ptr<::tzc::detail::Attachment> lasting_raw(const Stock& publisher) {
  if (!publisher) return nullptr;
  return ::tzc::detail::lasting_attachment<::sensor_msgs::Image>(raw_topic(publisher), std::true_type());
}

}  // namespace detail

/// The same where the publisher must stay image_transport's, for example because a library's object gets a copy of it: the raw transport
/// uses shared memory for as long as the program advertises the topic, with one copy of what is published. Returns the publisher. Thread-safe.
inline ::image_transport::Publisher attached(const ::image_transport::Publisher& publisher) {
  detail::lasting_raw(publisher);
  return publisher;
}
inline ::image_transport::CameraPublisher attached(const ::image_transport::CameraPublisher& publisher) {
  detail::lasting_raw(publisher);
  return publisher;
}

/// `publisher.publish(image)` with a publisher that stays image_transport's; the first call attaches shared memory to the raw transport, for
/// as long as the program advertises the topic. A tzc::sensor_msgs::Image in shared memory is not copied, a stock image once; either of
/// them, or a pointer to it, as Publisher::publish takes it. Thread-safe.
template <class Image>
void publish(const ::image_transport::Publisher& publisher, const Image& image) {
  Publisher(publisher, detail::lasting_raw(publisher)).publish(image);
}
template <class Image, class Info>
void publish(const ::image_transport::CameraPublisher& publisher, const Image& image, const Info& info) {
  CameraPublisher(publisher, detail::lasting_raw(publisher)).publish(image, info);
}
/// Stamps both, as the stock publisher does.
template <class Image, class Info>
void publish(const ::image_transport::CameraPublisher& publisher, Image& image, Info& info, ros::Time stamp) {
  CameraPublisher(publisher, detail::lasting_raw(publisher)).publish(image, info, stamp);
}

namespace detail {

/// An image transport that subscribes: a variable or a temporary.
class Transport {
 public:
  Transport(::image_transport::ImageTransport& transport) : transport_(transport) {}  // NOLINT: stands for it
  Transport(::image_transport::ImageTransport&& transport) : transport_(transport) {}  // NOLINT: as above
  ::image_transport::ImageTransport* operator->() const { return &transport_; }

 private:
  ::image_transport::ImageTransport& transport_;
};

/// Other transports have topics and message types of their own.
template <class Subscriber>
void attach_raw(const Subscriber& subscriber) {
  if (subscriber.getTransport() == "raw") attach<::sensor_msgs::Image>(subscriber.getTopic());
}
template <class Subscriber>
Subscriber attached(const Subscriber& subscriber) {
  if (subscriber) attach_raw(subscriber);
  return subscriber;
}

}  // namespace detail

/// image_transport::ImageTransport::subscribe in all its overloads. Only the raw transport uses shared
/// memory.
inline ::image_transport::Subscriber subscribe(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    const boost::function<void(const ::sensor_msgs::ImageConstPtr&)>& callback,
    const ros::VoidPtr& tracked_object = ros::VoidPtr(),
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribe(base_topic, queue_size, callback, tracked_object, hints));
}
inline ::image_transport::Subscriber subscribe(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (*callback)(const ::sensor_msgs::ImageConstPtr&),
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribe(base_topic, queue_size, callback, hints));
}
template <class T>
::image_transport::Subscriber subscribe(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (T::*callback)(const ::sensor_msgs::ImageConstPtr&), T* object,
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribe(base_topic, queue_size, callback, object, hints));
}
template <class T>
::image_transport::Subscriber subscribe(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (T::*callback)(const ::sensor_msgs::ImageConstPtr&), const boost::shared_ptr<T>& object,
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribe(base_topic, queue_size, callback, object, hints));
}

/// image_transport::ImageTransport::subscribeCamera in all its overloads.
inline ::image_transport::CameraSubscriber subscribeCamera(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    const ::image_transport::CameraSubscriber::Callback& callback,
    const ros::VoidPtr& tracked_object = ros::VoidPtr(),
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(
      transport->subscribeCamera(base_topic, queue_size, callback, tracked_object, hints));
}
inline ::image_transport::CameraSubscriber subscribeCamera(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (*callback)(const ::sensor_msgs::ImageConstPtr&, const ::sensor_msgs::CameraInfoConstPtr&),
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribeCamera(base_topic, queue_size, callback, hints));
}
template <class T>
::image_transport::CameraSubscriber subscribeCamera(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (T::*callback)(const ::sensor_msgs::ImageConstPtr&, const ::sensor_msgs::CameraInfoConstPtr&),
    T* object, const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribeCamera(base_topic, queue_size, callback, object, hints));
}
template <class T>
::image_transport::CameraSubscriber subscribeCamera(
    detail::Transport transport, const std::string& base_topic, std::uint32_t queue_size,
    void (T::*callback)(const ::sensor_msgs::ImageConstPtr&, const ::sensor_msgs::CameraInfoConstPtr&),
    const boost::shared_ptr<T>& object,
    const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  return detail::attached(transport->subscribeCamera(base_topic, queue_size, callback, object, hints));
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
    detail::attach_raw(*this);
  }
};

}  // namespace image_transport

namespace message_filters {

/// `filter.subscribe(transport, ...)` where the filter must stay image_transport's own, for example because a library's class has it. It
/// reads shared memory as tzc::image_transport::SubscriberFilter does.
inline void subscribe(::image_transport::SubscriberFilter& filter,
                      ::image_transport::ImageTransport& transport, const std::string& base_topic,
                      std::uint32_t queue_size,
                      const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  filter.subscribe(transport, base_topic, queue_size, hints);
  ::tzc::image_transport::detail::attach_raw(filter);
}

}  // namespace message_filters
}  // namespace tzc
