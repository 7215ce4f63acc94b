// SPDX-License-Identifier: BSD-3-Clause
/// Paths: arrays of messages that have strings, and nothing that lies in shared memory as it is.
///
/// Private parameters: mode (talk, listen), poses (several numbers, separated by blanks: one path with so many poses each), subscribers
/// (waited for; one of them on shared memory).
/// Both sides print a line for each path: number, poses, whether they are right.
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <tzc/ros.h>

#include <cstdlib>
#include <sstream>
#include <string>

namespace {

/// Short names lie inside of a std::string, long ones outside.
std::string frame_of(std::size_t i) {
  return std::string(i % 40, static_cast<char>('a' + i % 26));
}

void on_path(const nav_msgs::PathConstPtr& path) {
  bool right = true;
  for (std::size_t i = 0; i < path->poses.size(); ++i)
    right = right && path->poses[i].header.frame_id == frame_of(i) &&
            path->poses[i].pose.position.x == static_cast<double>(i);
  std::printf("{\"number\": %d, \"poses\": %zu, \"seq\": %u, \"right\": %s}\n",
              std::atoi(path->header.frame_id.c_str()), path->poses.size(), path->header.seq,
              right ? "true" : "false");
  std::fflush(stdout);
}

nav_msgs::Path path_of(int number, std::size_t poses) {
  nav_msgs::Path path;
  path.header.frame_id = std::to_string(number);
  path.poses.resize(poses);
  for (std::size_t i = 0; i < poses; ++i) {
    path.poses[i].header.frame_id = frame_of(i);
    path.poses[i].pose.position.x = static_cast<double>(i);
  }
  return path;
}

void talk(ros::NodeHandle& node, std::istringstream poses, std::uint32_t subscribers) {
  const tzc::Publisher publisher = tzc::advertise<nav_msgs::Path>(node, "path", 100);
  while (ros::ok() &&
         (publisher.getNumSubscribers() < subscribers || publisher.statistics().shared_subscribers == 0))
    ros::WallDuration(0.01).sleep();
  int number = 0;
  for (std::size_t count; poses >> count; ++number) publisher.publish(path_of(number, count));
  ros::WallDuration(1).sleep();
  const tzc::PublisherStatistics counted = publisher.statistics();
  std::printf("{\"shared\": %llu, \"serialized\": %llu}\n", (unsigned long long)counted.shared,
              (unsigned long long)counted.serialized);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "paths");
  ros::NodeHandle node, options("~");
  if (options.param<std::string>("mode", "talk") == "talk") {
    talk(node, std::istringstream(options.param<std::string>("poses", "")),
         static_cast<std::uint32_t>(options.param("subscribers", 1)));
  } else {
    const ros::Subscriber subscriber = options.param("plain", false)
                                           ? node.subscribe("path", 100, on_path)
                                           : tzc::subscribe(node, "path", 100, on_path);
    ros::spin();
  }
}
