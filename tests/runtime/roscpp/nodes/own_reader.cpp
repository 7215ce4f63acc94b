// SPDX-License-Identifier: BSD-3-Clause
/// Publishes images that a callback of the same process reads, each with a number of the program's own in header.seq;
/// prints a line for each that the callback got, and ends when it has all of them.
///
/// Private parameters: library (roscpp, image_transport), ported (publishes twins through TZC), pointer (publishes by
/// pointer), writer (the callback may write), keep (it keeps all images), count, bytes (of an image), subscribers (waits for so many),
/// shared (and for so many of them on shared memory).
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/image_transport.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

constexpr std::uint32_t kOwnNumber = 7000000;
int seen = 0;
bool keeps = false;
std::vector<sensor_msgs::ImageConstPtr> kept;

void on_image(const sensor_msgs::ImageConstPtr& image) {
  tzc_test::print_image(*image);
  if (keeps) kept.push_back(image);
  ++seen;
}
void on_writable_image(const sensor_msgs::ImagePtr& image) {
  on_image(image);
}

std::size_t shared_subscribers(const ros::Publisher&) {
  return 0;
}
std::size_t shared_subscribers(const image_transport::Publisher&) {
  return 0;
}
template <class Publisher>
std::size_t shared_subscribers(const Publisher& publisher) {
  return publisher.statistics().shared_subscribers;
}

template <class Image, class Publisher>
void run(const Publisher& publisher) {
  const ros::NodeHandle options("~");
  const int count = options.param("count", 50), shared = options.param("shared", 0);
  const auto bytes = static_cast<std::size_t>(options.param("bytes", 10000));
  const auto subscribers = static_cast<std::uint32_t>(options.param("subscribers", 1));
  const bool by_pointer = options.param("pointer", false);
  const auto is_ready = [&] {
    return publisher.getNumSubscribers() >= subscribers && int(shared_subscribers(publisher)) >= shared;
  };
  for (; ros::ok() && !is_ready(); ros::spinOnce()) ros::WallDuration(0.01).sleep();
  for (int number = 0; ros::ok() && number < count; ++number, ros::spinOnce()) {
    const auto image = boost::make_shared<Image>();
    tzc_test::fill_image(*image, static_cast<std::uint32_t>(number), bytes);
    image->header.seq = kOwnNumber + static_cast<std::uint32_t>(number);
    if (by_pointer)
      publisher.publish(image);
    else
      publisher.publish(*image);
    ros::WallDuration(0.001).sleep();
  }
  for (; ros::ok() && seen < count; ros::spinOnce()) ros::WallDuration(0.01).sleep();
  ros::WallDuration(0.5).sleep();  // for the links to other processes
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "own_reader");
  ros::NodeHandle node;
  const ros::NodeHandle options("~");
  keeps = options.param("keep", false);
  const ros::Subscriber reader = options.param("writer", false)
                                     ? node.subscribe("image", 1000, on_writable_image)
                                     : node.subscribe("image", 1000, on_image);
  const bool is_ported = options.param("ported", false);
  if (options.param<std::string>("library", "roscpp") == "roscpp") {
    if (is_ported)
      run<tzc::sensor_msgs::Image>(tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 1000));
    else
      run<sensor_msgs::Image>(node.advertise<sensor_msgs::Image>("image", 1000));
    return 0;
  }
  image_transport::ImageTransport transport(node);
  if (is_ported)
    run<tzc::sensor_msgs::Image>(tzc::image_transport::advertise(transport, "image", 1000));
  else
    run<sensor_msgs::Image>(transport.advertise("image", 1000));
  return 0;
}
