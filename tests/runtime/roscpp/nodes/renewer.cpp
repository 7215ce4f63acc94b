// SPDX-License-Identifier: BSD-3-Clause
/// Ends a direct subscription and makes it anew under a mutex that its callback takes, time after time. Prints as JSON whether it came
/// to an end of that: what ended first has nothing to wait for.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "race.h"

namespace {

std::mutex state_mutex;
std::atomic<int> rounds{0};

ros::Subscriber subscribe(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> callback =
      [](const sensor_msgs::ImageConstPtr&) { const std::lock_guard<std::mutex> lock(state_mutex); };
  ros::SubscribeOptions options = ros::SubscribeOptions::create<sensor_msgs::Image>(
      "image", 10, callback, ros::VoidConstPtr(), tzc::direct_dispatch_queue());
  options.allow_concurrent_callbacks = true;
  return tzc::subscribe<sensor_msgs::Image>(node, options);
}

void renew(ros::NodeHandle& node, ros::Subscriber& subscriber) {
  subscriber.shutdown();
  const std::lock_guard<std::mutex> lock(state_mutex);
  const ros::Subscriber fresh = subscribe(node);
  ros::WallDuration(0.01).sleep();  // its callback gets what is latched, and waits for the mutex
  subscriber = fresh;
  ++rounds;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "renewer");
  ros::NodeHandle node;
  tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 10, true);
  tzc_test::publish(publisher, 0, 1);
  const ros::Subscriber keeps_the_topic = node.subscribe<sensor_msgs::Image>(
      "image", 1,
      boost::function<void(const sensor_msgs::ImageConstPtr&)>([](const sensor_msgs::ImageConstPtr&) {}));
  std::thread([&node] {
    ros::Subscriber subscriber = subscribe(node);
    while (rounds < 50) renew(node, subscriber);
  }).detach();
  ros::AsyncSpinner spinner(2);
  spinner.start();
  tzc_test::print_event("renewed", tzc_test::eventually([] { return rounds >= 50; }));
  std::quick_exit(0);  // the thread may hang
}
