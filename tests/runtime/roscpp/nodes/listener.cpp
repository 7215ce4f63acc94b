// SPDX-License-Identifier: BSD-3-Clause
/// Prints one line of JSON for each image it gets: number, seq, whether the bytes are right, whether they lie in a
/// shared segment.
///
/// Private parameters: mode (pointer, reference, value, mutable, event, direct, filter, late_attach, plain),
/// queue, threads (0: ros::spin).
#include <message_filters/simple_filter.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/message_filters.h>
#include <tzc/ros.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "pattern.h"

namespace {

void print(const sensor_msgs::Image& image) {
  const auto number = static_cast<std::uint32_t>(std::atoi(image.header.frame_id.c_str()));
  const double latency = (ros::Time::now() - image.header.stamp).toSec() * 1e6;
  std::printf("{\"number\": %u, \"seq\": %u, \"right\": %s, \"shared\": %s, \"latency_us\": %.1f}\n", number,
              image.header.seq, tzc_test::has_pattern(image.data.data(), image.data.size(), number) ? "true" : "false",
              tzc::in_segment(image.data.data()) ? "true" : "false", latency);
  std::fflush(stdout);
}

void spoil(sensor_msgs::Image& image) {
  if (!image.data.empty()) image.data[0] ^= 0xff;
}

void on_pointer(const sensor_msgs::ImageConstPtr& image) { print(*image); }
void on_reference(const sensor_msgs::Image& image) { print(image); }
void on_value(sensor_msgs::Image image) {
  print(image);
  spoil(image);
}
void on_mutable(const sensor_msgs::ImagePtr& image) {
  print(*image);
  spoil(*image);
}
void on_event(const ros::MessageEvent<sensor_msgs::Image>& event) {
  print(*event.getMessage());
  spoil(*event.getMessage());
}

ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& mode, int queue) {
  if (mode == "pointer") return tzc::subscribe(node, "image", queue, on_pointer);
  if (mode == "reference") return tzc::subscribe(node, "image", queue, on_reference);
  if (mode == "value") return tzc::subscribe(node, "image", queue, on_value);
  if (mode == "mutable") return tzc::subscribe(node, "image", queue, on_mutable);
  if (mode == "event") return tzc::subscribe(node, "image", queue, on_event);
  if (mode == "direct") return tzc::subscribe_direct(node, "image", queue, on_pointer);
  const ros::Subscriber subscriber = node.subscribe("image", queue, on_pointer);
  if (mode == "late_attach") tzc::attach<sensor_msgs::Image>(node, "image");
  return subscriber;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "listener", ros::init_options::AnonymousName);
  ros::NodeHandle node, options("~");
  const std::string mode = options.param<std::string>("mode", "pointer");
  const int queue = options.param("queue", 100);
  std::unique_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>> filter;
  ros::Subscriber subscriber;
  if (mode == "filter") {
    filter.reset(new tzc::message_filters::Subscriber<sensor_msgs::Image>(node, "image", queue));
    filter->registerCallback(on_mutable);
  } else {
    subscriber = subscribe(node, mode, queue);
  }
  const int threads = options.param("threads", 0);
  if (threads == 0) {
    ros::spin();
  } else {
    ros::AsyncSpinner spinner(static_cast<std::uint32_t>(threads));
    spinner.start();
    ros::waitForShutdown();
  }
}
