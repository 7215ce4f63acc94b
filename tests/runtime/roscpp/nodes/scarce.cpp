// SPDX-License-Identifier: BSD-3-Clause
/// A publisher that lacks something when it is ported to its subscriber. Prints what happened as lines of JSON ("event").
///
/// Private parameter: lacks (descriptors, of which it has some again afterwards; entropy: its sandbox forbids to ask the kernel for some).
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <vector>

#include "race.h"

namespace {

std::atomic<bool> is_entropy_forbidden{false};

}  // namespace

/// In place of the C library's.
extern "C" int getentropy(void* to, std::size_t bytes) {
  if (is_entropy_forbidden) {
    errno = ENOSYS;
    return -1;
  }
  return syscall(SYS_getrandom, to, bytes, 0) == static_cast<long>(bytes) ? 0 : -1;
}

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

void lack_entropy(ros::NodeHandle& node) {
  is_entropy_forbidden = true;
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  print_event("shared", eventually([&] { return publisher.statistics().shared_subscribers == 1; }));
  tzc_test::publish(publisher, 0, 10);
  ros::WallDuration(1).sleep();
}

void lack_descriptors(ros::NodeHandle& node) {
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

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "scarce");
  ros::NodeHandle node;
  if (ros::NodeHandle("~").param<std::string>("lacks", "descriptors") == "entropy")
    lack_entropy(node);
  else
    lack_descriptors(node);
}
