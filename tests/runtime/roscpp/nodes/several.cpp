// SPDX-License-Identifier: BSD-3-Clause
/// Several callbacks of different kinds on one topic in one process; each line tells which callback it is
/// from.
///
/// Private parameter: callbacks, some of: pointer value mutable event shape_shifter plain late_shape_shifter
/// (subscribes a second after the others), attach (no callback: the topic is attached for images). Says when
/// all of them are there.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <topic_tools/shape_shifter.h>
#include <tzc/ros.h>

#include <sstream>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

void print(const std::string& callback, const sensor_msgs::Image& image) {
  tzc_test::print_image(image, "\"callback\": \"" + callback + "\", ");
}

void on_pointer(const sensor_msgs::ImageConstPtr& image) {
  print("pointer", *image);
}
void on_plain(const sensor_msgs::ImageConstPtr& image) {
  print("plain", *image);
}
void on_value(sensor_msgs::Image image) {
  print("value", image);
}
void on_mutable(const sensor_msgs::ImagePtr& image) {
  print("mutable", *image);
  image->data.assign(image->data.size(), 0);
}
void on_event(const ros::MessageEvent<sensor_msgs::Image const>& event) {
  tzc_test::print_image(*event.getConstMessage(),
                        "\"callback\": \"event\", \"publisher\": \"" + event.getPublisherName() + "\", ");
}
void on_shape_shifter(const topic_tools::ShapeShifter::ConstPtr& message) {
  print("shape_shifter", *message->instantiate<sensor_msgs::Image>());
}

ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& callback) {
  if (callback == "pointer") return tzc::subscribe(node, "image", 100, on_pointer);
  if (callback == "value") return tzc::subscribe(node, "image", 100, on_value);
  if (callback == "mutable") return tzc::subscribe(node, "image", 100, on_mutable);
  if (callback == "event") return tzc::subscribe(node, "image", 100, on_event);
  if (callback == "plain") return node.subscribe("image", 100, on_plain);
  return node.subscribe("image", 100, on_shape_shifter);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "several");
  ros::NodeHandle node, options("~");
  std::istringstream callbacks(options.param<std::string>("callbacks", "pointer"));
  std::vector<ros::Subscriber> subscribers;
  for (std::string callback; callbacks >> callback;) {
    if (callback == "attach") {
      tzc::attach<sensor_msgs::Image>(node, "image");
      continue;
    }
    if (callback != "late_shape_shifter") {
      subscribers.push_back(subscribe(node, callback));
      continue;
    }
    const ros::WallTime later = ros::WallTime::now() + ros::WallDuration(1.0);
    while (ros::ok() && ros::WallTime::now() < later)
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    subscribers.push_back(subscribe(node, callback));
  }
  std::puts("{\"event\": \"ready\"}");
  std::fflush(stdout);
  ros::spin();
}
