// SPDX-License-Identifier: BSD-3-Clause
/// A publisher. One of its subscribers is stopped, or killed afterwards; the others must not notice. Prints what
/// happened as lines of JSON ("event").
///
/// Private parameters: pid (of the subscriber that is stopped), scene, one of
///   offers  it is stopped when it is called with its first offer; 12 topics, two subscribers each
///   killed  it is stopped, misses messages, and is killed
///   return  no process is stopped: the channel breaks, and what is left in it is serialized slowly
///   memory  likewise, and the first message of these finds no memory
///   endless likewise, and each that is serialized brings two that are published; a subscriber of another topic comes meanwhile
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <signal.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <atomic>
#include <new>
#include <string>
#include <vector>

#include "gate.h"
#include "image_line.h"
#include "stop.h"
#include "sync_point/sync_point.h"

namespace {

using tzc_test::Gate;

Gate& gate() {
  static auto* const instance = new Gate;
  return *instance;
}

pid_t other_pid = 0;
std::atomic<int> serialized{0};

void print_event(const std::string& event, double value) {
  std::printf("{\"event\": \"%s\", \"value\": %.3f}\n", event.c_str(), value);
  std::fflush(stdout);
}

template <class Condition>
bool eventually(Condition holds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(60);
  while (ros::ok() && !holds() && ros::WallTime::now() < end) ros::WallDuration(0.001).sleep();
  return holds();
}

void publish(const tzc::Publisher& publisher, std::uint32_t number, std::size_t bytes = 20000) {
  tzc::sensor_msgs::Image image;
  publisher.allocate(image);
  tzc_test::fill_image(image, number, bytes);
  publisher.publish(image);
}

void offers(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* name) {
    if (std::string(name) != "offer: calls" || gate().happened("called")) return;
    tzc_test::stop(other_pid);
    gate().tell("called");
  };
  std::vector<tzc::Publisher> publishers;
  for (int i = 0; i < 12; ++i)
    publishers.push_back(tzc::advertise<tzc::sensor_msgs::Image>(node, "image" + std::to_string(i), 10));
  gate().wait_for({"called"});
  const ros::WallTime start = ros::WallTime::now();
  for (const tzc::Publisher& publisher : publishers)
    eventually([&] { return publisher.statistics().shared_subscribers > 0; });
  print_event("seconds until the healthy one is shared", (ros::WallTime::now() - start).toSec());
  kill(other_pid, SIGCONT);
  for (const tzc::Publisher& publisher : publishers)
    eventually([&] { return publisher.statistics().shared_subscribers == 2; });
  print_event("both are shared", 1);
}

void killed(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* name) {
    if (std::string(name) == "return: serialized") ++serialized;
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  eventually([&] { return publisher.statistics().shared_subscribers == 2; });
  for (std::uint32_t number = 0; number < 50; ++number) {
    if (number == 10) tzc_test::stop(other_pid);
    publish(publisher, number, 500000);
    ros::WallDuration(0.01).sleep();
  }
  kill(other_pid, SIGKILL);
  eventually([&] { return publisher.getNumSubscribers() == 1; });
  publish(publisher, 50);
  ros::WallDuration(1).sleep();
  print_event("serialized for the dead", serialized);
}

/// One more segment than a connection takes breaks the channel. Keeps the memory of the images.
std::uint32_t break_channel(const tzc::Publisher& publisher, std::vector<tzc::sensor_msgs::Image>& hoard) {
  eventually([&] { return publisher.statistics().shared_subscribers == 1; });
  hoard.resize(300);
  std::uint32_t number = 0;
  for (tzc::sensor_msgs::Image& image : hoard) {
    tzc::MemoryOptions memory;
    memory.size = 65536;
    tzc::message::allocate(image, std::shared_ptr<tzc::MemorySource>(*tzc::SegmentMemory::create(memory)));
    tzc_test::fill_image(image, number++, 20000);
    publisher.publish(image);
  }
  return number;
}

void return_slowly(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* name) {
    if (std::string(name) != "return: serialized" || gate().happened("serializing")) return;
    gate().tell("serializing");
    print_event("published meanwhile", gate().wait_for({"published"}, std::chrono::milliseconds(5000)));
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 1000);
  std::vector<tzc::sensor_msgs::Image> hoard;
  const std::uint32_t number = break_channel(publisher, hoard);
  gate().wait_for({"serializing"});
  publish(publisher, number);
  gate().tell("published");
  ros::WallDuration(2).sleep();
}

void return_without_memory(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* name) {
    if (std::string(name) != "return: serialized" || gate().happened("refused")) return;
    gate().tell("refused");
    print_event("refused", 1);
    throw std::bad_alloc();
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 1000);
  std::vector<tzc::sensor_msgs::Image> hoard;
  const std::uint32_t number = break_channel(publisher, hoard);
  gate().wait_for({"refused"});
  publish(publisher, number);
  ros::WallDuration(3).sleep();
}

tzc::Publisher endless;
std::atomic<bool> goes_on{true};

void return_for_ever(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* name) {
    if (std::string(name) != "return: serialized" || !goes_on) return;
    gate().tell("serializing");
    for (int i = 0; i < 2; ++i) publish(endless, 1000);
  };
  endless = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 10);
  std::vector<tzc::sensor_msgs::Image> hoard;
  break_channel(endless, hoard);
  gate().wait_for({"serializing"});
  const tzc::Publisher other = tzc::advertise<tzc::sensor_msgs::Image>(node, "other", 10);
  const bool is_shared = eventually([&] { return other.statistics().shared_subscribers == 1; });
  print_event("another topic is shared meanwhile", is_shared);
  goes_on = false;
  ros::WallDuration(1).sleep();
  endless.shutdown();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "stopper");
  ros::NodeHandle node, options("~");
  other_pid = options.param("pid", 0);
  const std::string scene = options.param<std::string>("scene", "");
  if (scene == "offers") offers(node);
  if (scene == "killed") killed(node);
  if (scene == "return") return_slowly(node);
  if (scene == "memory") return_without_memory(node);
  if (scene == "endless") return_for_ever(node);
  tzc::sync_point_hook = nullptr;
}
