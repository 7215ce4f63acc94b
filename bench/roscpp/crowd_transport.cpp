// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <numeric>
#include <vector>

#include "roscpp/crowd.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::uint32_t queue_size = 10;

using Callback = boost::function<void(const ::sensor_msgs::ImageConstPtr&)>;

Callback calling(const std::function<void()>& on_message) {
  return [on_message](const ::sensor_msgs::ImageConstPtr&) { on_message(); };
}

template <class Publisher>
class Topics : public CrowdTransport {
 public:
  std::size_t connected() const override {
    return sum([](const Publisher& publisher) { return std::size_t{publisher.getNumSubscribers()}; });
  }

 protected:
  template <class Count>
  std::size_t sum(Count count) const {
    return std::accumulate(publishers_.begin(), publishers_.end(), std::size_t{0},
                           [count](std::size_t all, const Publisher& one) { return all + count(one); });
  }

  ros::NodeHandle node_;
  std::vector<Publisher> publishers_;
  std::vector<ros::Subscriber> subscribers_;
};

class TcprosTopics final : public Topics<ros::Publisher> {
 public:
  const char* name() const override { return "tcpros"; }
  bool shares_memory() const override { return false; }
  std::size_t upgraded() const override { return 0; }

  void advertise(const std::string& topic, std::size_t) override {
    publishers_.push_back(node_.advertise<::sensor_msgs::Image>(topic, queue_size));
  }
  void subscribe(const std::string& topic, const std::function<void()>& on_message) override {
    subscribers_.push_back(node_.subscribe<::sensor_msgs::Image>(topic, queue_size, calling(on_message)));
  }
  void publish(std::size_t bytes) const override {
    ::sensor_msgs::Image image;
    image.data.resize(bytes);
    for (const ros::Publisher& publisher : publishers_) publisher.publish(image);
  }
};

class TzcTopics final : public Topics<Publisher> {
 public:
  const char* name() const override { return "tzc"; }
  bool shares_memory() const override { return true; }
  std::size_t upgraded() const override {
    return sum([](const Publisher& publisher) { return publisher.statistics().shared_subscribers; });
  }

  void advertise(const std::string& topic, std::size_t memory_bytes) override {
    publishers_.push_back(tzc::advertise<sensor_msgs::Image>(node_, topic, queue_size, memory_bytes));
  }
  void subscribe(const std::string& topic, const std::function<void()>& on_message) override {
    subscribers_.push_back(
        tzc::subscribe<::sensor_msgs::Image>(node_, topic, queue_size, calling(on_message)));
  }
  void publish(std::size_t bytes) const override {
    for (const Publisher& publisher : publishers_) {
      sensor_msgs::Image image;
      image.data.resize(bytes);
      publisher.allocate(image);
      publisher.publish(image);
    }
  }
};

}  // namespace

std::unique_ptr<CrowdTransport> crowd_transport(Transport transport) {
  if (transport == Transport::tcpros) return std::make_unique<TcprosTopics>();
  return std::make_unique<TzcTopics>();
}

}  // namespace bench
}  // namespace tzc
