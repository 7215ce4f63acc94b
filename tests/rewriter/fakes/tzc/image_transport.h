// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <image_transport/subscriber_filter.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/CameraInfo.h>
#include <tzc/sensor_msgs/Image.h>
namespace tzc {
namespace image_transport {
class Publisher : public ::tzc::Publisher {};
class CameraPublisher {
 public:
  template <class I, class C>
  void publish(const I&, const C&) const {}
  template <class I, class C>
  void publish(I&, C&, ros::Time) const {}
  template <class M>
  bool allocate(M&) const {
    static_assert(sizeof(typename M::Stock) > 0, "a twin");
    return true;
  }
  uint32_t getNumSubscribers() const { return 1; }
};
template <class... A>
Publisher advertise(::image_transport::ImageTransport it, A&&... a) {
  it.advertise(std::forward<A>(a)...);
  return {};
}
template <class... A>
CameraPublisher advertiseCamera(::image_transport::ImageTransport it, A&&... a) {
  it.advertiseCamera(std::forward<A>(a)...);
  return {};
}
inline Publisher attach_publisher(const ::image_transport::Publisher&) {
  return {};
}
inline CameraPublisher attach_publisher(const ::image_transport::CameraPublisher&) {
  return {};
}
inline ::image_transport::Publisher attached(const ::image_transport::Publisher& publisher) {
  return publisher;
}
inline ::image_transport::CameraPublisher attached(const ::image_transport::CameraPublisher& publisher) {
  return publisher;
}
template <class M>
void publish(const ::image_transport::Publisher&, const M&) {}
template <class M, class I>
void publish(const ::image_transport::CameraPublisher&, const M&, const I&) {}
template <class M, class I>
void publish(const ::image_transport::CameraPublisher&, M&, I&, ros::Time) {}
template <class... A>
::image_transport::Subscriber subscribe(::image_transport::ImageTransport it, A&&... a) {
  return it.subscribe(std::forward<A>(a)...);
}
template <class... A>
::image_transport::CameraSubscriber subscribeCamera(::image_transport::ImageTransport it, A&&... a) {
  return it.subscribeCamera(std::forward<A>(a)...);
}
class SubscriberFilter : public ::image_transport::SubscriberFilter {
  using ::image_transport::SubscriberFilter::SubscriberFilter;
};
}  // namespace image_transport
namespace message_filters {
inline void subscribe(::image_transport::SubscriberFilter& filter, ::image_transport::ImageTransport& it,
                      const std::string& topic, uint32_t queue,
                      const ::image_transport::TransportHints& hints = ::image_transport::TransportHints()) {
  filter.subscribe(it, topic, queue, hints);
}
}  // namespace message_filters
}  // namespace tzc
