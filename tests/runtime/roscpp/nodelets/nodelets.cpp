// SPDX-License-Identifier: BSD-3-Clause
/// Nodelets on the topic "image". What they print (image_line.h) also tells the address of the message object
/// and who prints: intraprocess subscribers get the very object that was published.
///
/// Private parameters: mode (twin, stock_pointer, plain) and rate of the Talker; ported (bool) of the
/// Listener.
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#include <pluginlib/class_list_macros.hpp>

#include <sstream>
#include <string>

#include "../nodes/image_line.h"

namespace tzc_test {
namespace {

std::string origin(const std::string& who, const void* message) {
  std::ostringstream text;
  text << "\"topic\": \"" << who << "\", \"address\": \"" << message << "\", ";
  return text.str();
}

}  // namespace

class Talker : public nodelet::Nodelet {
  void onInit() override {
    ros::NodeHandle& node = getNodeHandle();
    mode_ = getPrivateNodeHandle().param<std::string>("mode", "twin");
    if (mode_ == "plain")
      plain_ = node.advertise<sensor_msgs::Image>("image", 10);
    else
      shared_ = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 10);
    const double rate = getPrivateNodeHandle().param("rate", 50.0);
    timer_ = node.createTimer(ros::Duration(1 / rate), [this](const ros::TimerEvent&) { publish(); });
  }

  void publish() {
    if (mode_ == "twin") {
      tzc::sensor_msgs::Image image;
      shared_.allocate(image);
      fill_image(image, number_++, 50000);
      return shared_.publish(image);
    }
    const auto image = boost::make_shared<sensor_msgs::Image>();
    fill_image(*image, number_++, 50000);
    print_image(*image, origin("published", image.get()));
    if (mode_ == "plain")
      plain_.publish(image);
    else
      shared_.publish(image);
  }

  std::string mode_;
  std::uint32_t number_ = 0;
  ros::Publisher plain_;
  tzc::Publisher shared_;
  ros::Timer timer_;
};

class Listener : public nodelet::Nodelet {
  void onInit() override {
    if (getPrivateNodeHandle().param("ported", true))
      subscriber_ = tzc::subscribe(getNodeHandle(), "image", 100, &Listener::see, this);
    else
      subscriber_ = getNodeHandle().subscribe("image", 100, &Listener::see, this);
  }
  void see(const sensor_msgs::ImageConstPtr& image) { print_image(*image, origin(getName(), image.get())); }

  ros::Subscriber subscriber_;
};

}  // namespace tzc_test

PLUGINLIB_EXPORT_CLASS(tzc_test::Talker, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(tzc_test::Listener, nodelet::Nodelet)
