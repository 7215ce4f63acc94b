// SPDX-License-Identifier: BSD-3-Clause
/// Compares publishers of TZC with stock ones, as a package does of which only some are ported.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <tzc/image_transport.h>
#include <tzc/ros.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

/// Whether two publishers that are not the same are taken for that, or are in no order.
template <class One, class Other>
bool is_mixed_up(const One& one, const Other& other) {
  return one == other || other == one || !(one != other) || !(other != one) || (one < other) == (other < one);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "compared");
  ros::NodeHandle node;
  const tzc::Publisher ported = tzc::advertise<sensor_msgs::Image>(node, "ported", 1);
  const ros::Publisher stock = node.advertise<std_msgs::String>("stock", 1);
  image_transport::ImageTransport transport(node);
  const tzc::image_transport::Publisher ported_image = tzc::image_transport::advertise(transport, "left", 1);
  const image_transport::Publisher image = transport.advertise("right", 1);
  const std::vector<tzc::Publisher> all(1, ported);
  const bool found = std::find(all.begin(), all.end(), stock) != all.end();
  const bool mixed_up = is_mixed_up(ported, stock) || is_mixed_up(ported_image, image) || found;
  std::printf("{\"event\": \"publishers are mixed up\", \"happened\": %s}\n", mixed_up ? "true" : "false");
  return 0;
}
