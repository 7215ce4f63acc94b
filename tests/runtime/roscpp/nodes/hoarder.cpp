// SPDX-License-Identifier: BSD-3-Clause
/// Publishes images that lie in more segments than one connection can carry, and keeps them all; then
/// ordinary ones.
///
/// Private parameters: segments, then (images after those), until_shared (0, or so many more when the
/// subscriber is on shared memory again).
#include <ros/ros.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <vector>

#include "image_line.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "hoarder");
  ros::NodeHandle node, options("~");
  const int segments = options.param("segments", 300), then = options.param("then", 50);
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 1000, 4000000);
  while (ros::ok() && publisher.statistics().shared_subscribers == 0) ros::WallDuration(0.01).sleep();
  std::vector<tzc::sensor_msgs::Image> hoard(static_cast<std::size_t>(segments));
  const int more = options.param("until_shared", 0);
  bool returned = more == 0, shared_again = more == 0;
  int end = segments + then;
  for (int number = 0; ros::ok() && (number < end || !shared_again); ++number) {
    tzc::sensor_msgs::Image ordinary;
    tzc::sensor_msgs::Image& image = number < segments ? hoard[static_cast<std::size_t>(number)] : ordinary;
    tzc::MemoryOptions memory;
    memory.size = 65536;
    if (number < segments)
      tzc::message::allocate(image, std::shared_ptr<tzc::MemorySource>(*tzc::SegmentMemory::create(memory)));
    else
      publisher.allocate(image);
    tzc_test::fill_image(image, static_cast<std::uint32_t>(number), 10000);
    publisher.publish(image);
    ros::WallDuration(0.01).sleep();
    returned = returned || publisher.statistics().shared_subscribers == 0;
    if (!returned || shared_again || publisher.statistics().shared_subscribers == 0) continue;
    shared_again = true;
    end = number + more;
  }
  ros::WallDuration(0.5).sleep();
}
