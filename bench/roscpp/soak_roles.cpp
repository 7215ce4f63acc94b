// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/soak_roles.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <memory>
#include <random>

#include "measure.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t kb = 1 << 10, mb = 1 << 20;
constexpr std::size_t stride = 4 * kb;  // so that each page is looked at
constexpr std::size_t kept_of_a_topic = 20;
constexpr std::int64_t second = 1'000'000'000;

struct SoakTopic {
  const char* name;
  std::size_t smallest, largest;  // bytes of a message, uniform in the logarithm
  std::uint32_t queue_size;
  double rate_hz;
};

const std::vector<SoakTopic> lasting_topics{
    {"/soak/scans", kb, 16 * kb, 1000, 40},
    {"/soak/previews", 100 * kb, mb, 100, 20},
    {"/soak/clouds", mb, 8 * mb, 10, 10},
    {"/soak/panoramas", 30 * mb, 30 * mb, 1, 1},
};
const std::vector<SoakTopic> passing_topics{{"/soak/passing", 10 * kb, 4 * mb, 10, 10}};

std::vector<SoakTopic> all_topics() {
  std::vector<SoakTopic> all = lasting_topics;
  all.insert(all.end(), passing_topics.begin(), passing_topics.end());
  return all;
}

void start_node(const char* name) {
  ros::M_string remappings;
  ros::init(remappings, name, ros::init_options::NoSigintHandler);
}

std::uint8_t content_of(std::uint32_t number) {
  return static_cast<std::uint8_t>(number * 37 + 1);
}

bool intact(const ::sensor_msgs::Image& image) {
  if (image.data.size() != image.step || image.data.empty()) return false;
  const std::uint8_t expected = content_of(image.width);
  for (std::size_t at = 0; at < image.data.size(); at += stride)
    if (image.data[at] != expected) return false;
  return image.data.back() == expected;
}

/// Publishes one topic at its rate.
class Source {
 public:
  Source(ros::NodeHandle& node, const SoakTopic& topic)
      : topic_(topic), publisher_(advertise<sensor_msgs::Image>(node, topic.name, topic.queue_size)) {}

  std::int64_t due_ns() const { return due_ns_; }

  void publish() {
    due_ns_ = std::max(due_ns_ + static_cast<std::int64_t>(1e9 / topic_.rate_hz), now_ns() - second);
    sensor_msgs::Image image;
    publisher_.allocate(image);
    image.width = ++number_;
    image.step = static_cast<std::uint32_t>(next_bytes());
    image.data.resize(image.step, uninitialized);
    std::memset(image.data.data(), content_of(number_), image.step);
    publisher_.publish(image);
  }

 private:
  std::size_t next_bytes() {
    std::uniform_real_distribution<double> logarithm(std::log(static_cast<double>(topic_.smallest)),
                                                     std::log(static_cast<double>(topic_.largest)));
    return static_cast<std::size_t>(std::exp(logarithm(random_)));
  }

  const SoakTopic topic_;
  Publisher publisher_;
  std::mt19937_64 random_{1};
  std::uint32_t number_ = 0;
  std::int64_t due_ns_ = now_ns();
};

void publish(const char* name, const std::vector<SoakTopic>& topics, SoakCounts& counts) {
  start_node(name);
  ros::NodeHandle node;
  std::vector<Source> sources;
  for (const SoakTopic& topic : topics) sources.emplace_back(node, topic);
  while (ros::ok()) {
    const auto next = std::min_element(sources.begin(), sources.end(), [](const Source& a, const Source& b) {
      return a.due_ns() < b.due_ns();
    });
    const std::int64_t wait_ns = next->due_ns() - now_ns();
    if (wait_ns > 0) ros::WallDuration(static_cast<double>(wait_ns) / 1e9).sleep();
    next->publish();
    ++counts.published;
  }
}

/// Looks at a subscriber's messages when they come and, where they are kept, when it lets go of them.
class Sink {
 public:
  Sink(SoakCounts& counts, std::size_t kept) : counts_(counts), kept_(kept) {}

  void take(const ::sensor_msgs::ImageConstPtr& image) {
    ++counts_.received;
    look_at(*image);
    if (kept_ == 0) return;
    messages_.push_back(image);
    if (messages_.size() <= kept_) return;
    look_at(*messages_.front());
    messages_.pop_front();
  }

 private:
  void look_at(const ::sensor_msgs::Image& image) {
    if (!intact(image)) ++counts_.spoiled;
  }

  SoakCounts& counts_;
  const std::size_t kept_;
  std::deque<::sensor_msgs::ImageConstPtr> messages_;
};

using Callback = boost::function<void(const ::sensor_msgs::ImageConstPtr&)>;

/// A callback for each topic, with a sink of its own.
Callback into_new_sink(SoakCounts& counts, std::size_t kept) {
  const auto sink = std::make_shared<Sink>(counts, kept);
  return [sink](const ::sensor_msgs::ImageConstPtr& image) { sink->take(image); };
}

std::vector<ros::Subscriber> subscribe_to_all(ros::NodeHandle& node, SoakCounts& counts, std::size_t kept) {
  std::vector<ros::Subscriber> subscribers;
  for (const SoakTopic& topic : all_topics())
    subscribers.push_back(tzc::subscribe<::sensor_msgs::Image>(node, topic.name, topic.queue_size,
                                                               into_new_sink(counts, kept)));
  return subscribers;
}

void publish_for_long(SoakCounts& counts) {
  publish("soak_publisher", lasting_topics, counts);
}

void publish_until_killed(SoakCounts& counts) {
  publish("soak_killed_publisher", passing_topics, counts);
}

void receive(const char* name, SoakCounts& counts, std::size_t kept, void (*spin)()) {
  start_node(name);
  ros::NodeHandle node;
  const auto subscribers = subscribe_to_all(node, counts, kept);
  spin();
}

void spin_for_long(SoakCounts& counts) {
  receive("soak_subscriber", counts, 0, &ros::spin);
}

void keep(SoakCounts& counts) {
  receive("soak_keeper", counts, kept_of_a_topic, &tzc::spin);
}

void spin_while_stopped(SoakCounts& counts) {
  receive("soak_stopped", counts, 0, &tzc::spin);
}

void spin_until_killed(SoakCounts& counts) {
  receive("soak_killed", counts, kept_of_a_topic, &tzc::spin);
}

void receive_over_tcpros(SoakCounts& counts) {
  start_node("soak_plain");
  ros::NodeHandle node;
  std::vector<ros::Subscriber> subscribers;
  for (const SoakTopic& topic : passing_topics)
    subscribers.push_back(
        node.subscribe<::sensor_msgs::Image>(topic.name, topic.queue_size, into_new_sink(counts, 0)));
  ros::spin();
}

void dispatch_directly(SoakCounts& counts) {
  start_node("soak_direct");
  ros::NodeHandle node;
  std::vector<ros::Subscriber> subscribers;
  for (const SoakTopic& topic : all_topics())
    subscribers.push_back(
        subscribe_direct<::sensor_msgs::Image>(node, topic.name, topic.queue_size, into_new_sink(counts, 0)));
  ros::spin();
}

void come_and_go(SoakCounts& counts) {
  start_node("soak_guest");
  ros::NodeHandle node;
  while (ros::ok()) {
    const auto subscribers = subscribe_to_all(node, counts, kept_of_a_topic);
    const std::int64_t leave_ns = now_ns() + 5 * second;
    while (ros::ok() && now_ns() < leave_ns)
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  }
}

}  // namespace

const std::vector<SoakRole>& soak_roles() {
  static const std::vector<SoakRole> roles{
      {"publisher", Fate::lasts, publish_for_long},
      {"subscriber", Fate::lasts, spin_for_long},
      {"direct", Fate::lasts, dispatch_directly},
      {"keeper", Fate::lasts, keep},
      {"guest", Fate::lasts, come_and_go},
      {"stopped", Fate::stopped, spin_while_stopped},
      {"killed", Fate::killed, spin_until_killed},
      {"killed_publisher", Fate::killed, publish_until_killed},
      {"plain", Fate::lasts, receive_over_tcpros, true},
  };
  return roles;
}

}  // namespace bench
}  // namespace tzc
