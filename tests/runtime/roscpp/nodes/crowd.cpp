// SPDX-License-Identifier: BSD-3-Clause
/// Advertises many topics, image0, image1, ..., and publishes to the subscribed ones of them until it ends.
///
/// Private parameters: topics (how many), count (images on each), subscribers (topics that wait for one).
#include <ros/ros.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>
#include <vector>

#include "image_line.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "crowd");
  ros::NodeHandle node, options("~");
  std::vector<tzc::Publisher> publishers;
  for (int i = 0; i < options.param("topics", 100); ++i)
    publishers.push_back(tzc::advertise<tzc::sensor_msgs::Image>(node, "image" + std::to_string(i), 10));
  std::printf("{\"event\": \"advertised\", \"topics\": %zu}\n", publishers.size());
  std::fflush(stdout);
  const int subscribers = options.param("subscribers", 0), count = options.param("count", 20);
  for (int i = 0; i < subscribers; ++i)
    while (ros::ok() && publishers[i].getNumSubscribers() == 0) ros::WallDuration(0.01).sleep();
  ros::WallDuration(2).sleep();
  for (int number = 0; ros::ok() && number < count; ++number) {
    for (int i = 0; i < subscribers; ++i) {
      tzc::sensor_msgs::Image image;
      publishers[i].allocate(image);
      tzc_test::fill_image(image, static_cast<std::uint32_t>(number), 1000);
      publishers[i].publish(image);
    }
    ros::WallDuration(0.05).sleep();
  }
  std::size_t shared = 0;
  for (const tzc::Publisher& publisher : publishers) shared += publisher.statistics().shared_subscribers;
  std::printf("{\"event\": \"all published\", \"shared\": %zu}\n", shared);
  std::fflush(stdout);
  ros::WallDuration(1).sleep();
}
