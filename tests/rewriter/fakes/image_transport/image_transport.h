// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
namespace image_transport {
class Publisher {
 public:
  void publish(const sensor_msgs::Image&) const {}
  void publish(const sensor_msgs::ImageConstPtr&) const {}
  uint32_t getNumSubscribers() const { return 1; }
  std::string getTopic() const { return ""; }
  void shutdown() {}
};
class CameraPublisher {
 public:
  void publish(const sensor_msgs::Image&, const sensor_msgs::CameraInfo&) const {}
  void publish(const sensor_msgs::ImageConstPtr&, const sensor_msgs::CameraInfoConstPtr&) const {}
  void publish(sensor_msgs::Image&, sensor_msgs::CameraInfo&, ros::Time) const {}
  uint32_t getNumSubscribers() const { return 1; }
};
class Subscriber {};
class CameraSubscriber {};
class TransportHints {
 public:
  explicit TransportHints(const std::string& = "raw") {}
};
class SingleSubscriberPublisher {};
typedef boost::function<void(const SingleSubscriberPublisher&)> SubscriberStatusCallback;
class ImageTransport {
 public:
  explicit ImageTransport(const ros::NodeHandle&) {}
  Publisher advertise(const std::string&, uint32_t, bool = false) { return {}; }
  Publisher advertise(const std::string&, uint32_t, const SubscriberStatusCallback&,
                      const SubscriberStatusCallback& = {}) {
    return {};
  }
  CameraPublisher advertiseCamera(const std::string&, uint32_t, bool = false) { return {}; }
  template <class T>
  Subscriber subscribe(const std::string&, uint32_t, void (T::*)(const sensor_msgs::ImageConstPtr&), T*,
                       const TransportHints& = TransportHints()) {
    return {};
  }
  Subscriber subscribe(const std::string&, uint32_t, void (*)(const sensor_msgs::ImageConstPtr&),
                       const TransportHints& = TransportHints()) {
    return {};
  }
  template <class T>
  CameraSubscriber subscribeCamera(const std::string&, uint32_t,
                                   void (T::*)(const sensor_msgs::ImageConstPtr&,
                                               const sensor_msgs::CameraInfoConstPtr&),
                                   T*, const TransportHints& = TransportHints()) {
    return {};
  }
};
}  // namespace image_transport
