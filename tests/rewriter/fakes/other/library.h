// SPDX-License-Identifier: BSD-3-Clause
// Code of another package.
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
namespace other {
inline void rotate(sensor_msgs::Image&) {}
inline void inspect(const sensor_msgs::Image&) {}
inline sensor_msgs::Image grab() {
  return {};
}
inline sensor_msgs::ImagePtr grab_shared() {
  return {};
}
inline void watch(const ros::Publisher&) {}
inline ros::Publisher connect() {
  return {};
}
inline void decode(std::vector<uint8_t>&) {}
inline int gamma(int value, int) {
  return value;
}
inline void read(unsigned char*, std::size_t) {}
template <class M>
void log(const M&) {}
/// Keeps what it is given, for poll() to call.
inline void post(std::function<void()>) {}
inline void poll() {}
/// Advertises for its children and keeps a copy of each publisher.
class Nodelet {
 protected:
  template <class M>
  ros::Publisher advertise(ros::NodeHandle& nh, std::string topic, int queue, bool latch = false) {
    publishers_.push_back(nh.advertise<M>(topic, queue, latch));
    return publishers_.back();
  }
  ros::Publisher advertise_any(ros::NodeHandle&, const std::string&) { return {}; }

 private:
  std::vector<ros::Publisher> publishers_;
};
/// Advertises by itself what its children publish.
class Server {
 protected:
  ros::Publisher map_pub_;
  std::vector<ros::Publisher> map_pubs_;
  ros::Publisher* shared_pub_ = nullptr;
};
/// Publishes with publishers of its own.
class Recorder {
 public:
  void publish(const sensor_msgs::Image&, double) {}
  void publishCloud(const boost::shared_ptr<const sensor_msgs::PointCloud2>&) {}
  void publish(int) {}
};
class Source {
 public:
  virtual ~Source() {}
  virtual void fill(sensor_msgs::Image&) = 0;
};
}  // namespace other
