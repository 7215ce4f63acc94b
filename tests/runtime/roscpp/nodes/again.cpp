// SPDX-License-Identifier: BSD-3-Clause
/// A node that is started again: its first node handle is a temporary, whose end shuts it down. Prints for each life whether its subscription came
/// to shared memory. A talker publishes all the while.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/memory.h>
#include <tzc/ros.h>

#include "race.h"

namespace {

bool live() {
  ros::NodeHandle node;
  bool is_shared = false;
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> see =
      [&is_shared](const sensor_msgs::ImageConstPtr& image) {
        is_shared |= tzc::in_segment(image->data.data());
      };
  const ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 10, see);
  return tzc_test::eventually([&] {
    ros::spinOnce();
    return is_shared;
  });
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "again");
  ros::NodeHandle("~").param("rate", 30);
  for (const char* life : {"second life", "third life"}) tzc_test::print_event(life, live());
}
