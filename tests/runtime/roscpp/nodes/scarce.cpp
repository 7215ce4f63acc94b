// SPDX-License-Identifier: BSD-3-Clause
/// A publisher that has no descriptor left when it is ported to its subscriber, and has some again afterwards. Prints what happened as
/// lines of JSON ("event").
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sys/resource.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#include <unistd.h>

#include <vector>

#include "race.h"

namespace {

using tzc_test::eventually;
using tzc_test::print_event;

/// All descriptors that the process may still open.
std::vector<int> hoard() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = 256;
  setrlimit(RLIMIT_NOFILE, &limit);
  std::vector<int> descriptors;
  for (int descriptor = dup(0); descriptor >= 0; descriptor = dup(0)) descriptors.push_back(descriptor);
  return descriptors;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "scarce");
  ros::NodeHandle node;
  const ros::Publisher plain = node.advertise<sensor_msgs::Image>("image", 100);
  eventually([&] { return plain.getNumSubscribers() == 1; });
  const std::vector<int> descriptors = hoard();
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  ros::WallDuration(1).sleep();
  print_event("shared without descriptors", publisher.statistics().shared_subscribers == 1);
  for (const int descriptor : descriptors) close(descriptor);
  print_event("shared with some", eventually([&] { return publisher.statistics().shared_subscribers == 1; }));
  tzc_test::publish(publisher, 0, 10);
  ros::WallDuration(1).sleep();
}
