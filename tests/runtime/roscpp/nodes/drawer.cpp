// SPDX-License-Identifier: BSD-3-Clause
/// A publisher on "image" with a subscriber of its own that draws on what it gets by const pointer, as one that writes to
/// toCvShare(...)->image, on a thread that blocks all signals; and publishes that on "drawn". Prints what that subscriber gets
/// (image_line.h), and at the end whether the messages that were published have stayed as they were ("event", "kept").
///
/// Private parameters: bytes of an image; count; latch; subscribers (on shared memory) to wait for.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>

#include "image_line.h"
#include "race.h"

namespace {

void draw(const sensor_msgs::ImageConstPtr& received, const tzc::Publisher& drawn) {
  tzc_test::print_image(*received);
  auto& image = const_cast<sensor_msgs::Image&>(*received);
  const int number = std::atoi(image.header.frame_id.c_str());
  tzc_test::fill_pattern(image.data.data(), image.data.size(), static_cast<std::uint32_t>(number) + 1000);
  image.header.frame_id = std::to_string(number + 1000);
  drawn.publish(received);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "drawer");
  ros::NodeHandle node;
  const ros::NodeHandle own("~");
  const int bytes = own.param("bytes", 100000);
  const std::uint32_t count = static_cast<std::uint32_t>(own.param("count", 30));
  const std::size_t subscribers = static_cast<std::size_t>(own.param("subscribers", 1));
  const tzc::Publisher drawn = tzc::advertise<sensor_msgs::Image>(node, "drawn", 100);
  const tzc::Publisher publisher =
      tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100, own.param("latch", false));
  tzc_test::eventually([&] {
    return publisher.statistics().shared_subscribers == subscribers && drawn.getNumSubscribers() == 1;
  });
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> draws =
      [&](const sensor_msgs::ImageConstPtr& image) { draw(image, drawn); };
  const ros::Subscriber drawer = node.subscribe<sensor_msgs::Image>("image", 100, draws);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  bool kept = true;
  for (std::uint32_t number = 0; number < count; ++number) {
    tzc::sensor_msgs::Image image;
    publisher.allocate(image);
    tzc_test::fill_image(image, number, static_cast<std::size_t>(bytes));
    publisher.publish(image);
    ros::WallDuration(0.01).sleep();
    const tzc::sensor_msgs::Image& published = image;
    kept = kept && tzc_test::has_pattern(published.data.data(), published.data.size(), number);
  }
  tzc_test::print_event("kept", kept);
  ros::WallDuration(0.5).sleep();
}
