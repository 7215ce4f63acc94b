// SPDX-License-Identifier: BSD-3-Clause
/// Nodelets on the topic "image". What they print (image_line.h) also tells the address of the message object
/// and who prints: intraprocess subscribers get the very object that was published.
///
/// Private parameters: mode (twin, stock, stock_pointer, plain) and rate of the Talker; ported (bool) of the
/// Listener; mode (mutable, filter) of the Writer, which writes to what it gets.
#include <message_filters/subscriber.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
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
    if (mode_ == "stock") return shared_.publish(*image);
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

/// A callback that may write, and does: its message must be its own.
class Writer : public nodelet::Nodelet {
  void onInit() override {
    const std::string mode = getPrivateNodeHandle().param<std::string>("mode", "mutable");
    if (mode == "mutable") subscriber_ = getNodeHandle().subscribe("image", 100, &Writer::spoil, this);
    if (mode == "filter") {
      filter_.reset(new message_filters::Subscriber<sensor_msgs::Image>(getNodeHandle(), "image", 100));
      filter_->registerCallback(&Writer::spoil, this);
    }
  }
  void spoil(const sensor_msgs::ImagePtr& image) {
    print_image(*image, origin(getName(), image.get()));
    image->data.assign(image->data.size(), 0);
    image->data.resize(2 * image->data.size());
  }

  ros::Subscriber subscriber_;
  std::unique_ptr<message_filters::Subscriber<sensor_msgs::Image>> filter_;
};

}  // namespace tzc_test

PLUGINLIB_EXPORT_CLASS(tzc_test::Talker, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(tzc_test::Listener, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(tzc_test::Writer, nodelet::Nodelet)
