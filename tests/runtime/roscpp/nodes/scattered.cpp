// SPDX-License-Identifier: BSD-3-Clause
/// Point clouds whose channels are allocated one by one: more arrays of their own than a record may have.
///
/// Private parameters: mode (talk, listen), channels (several numbers, separated by blanks: one cloud with so many
/// channels each). Both sides print a line for each cloud: number, channels, whether its values are right.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/PointCloud.h>

#include <cstdlib>
#include <sstream>
#include <string>

namespace {

void on_cloud(const sensor_msgs::PointCloudConstPtr& cloud) {
  bool right = true;
  for (std::size_t i = 0; i < cloud->channels.size(); ++i)
    right = right && cloud->channels[i].values == std::vector<float>(4, static_cast<float>(i));
  std::printf("{\"number\": %d, \"channels\": %zu, \"seq\": %u, \"right\": %s}\n",
              std::atoi(cloud->header.frame_id.c_str()), cloud->channels.size(), cloud->header.seq,
              right ? "true" : "false");
  std::fflush(stdout);
}

tzc::sensor_msgs::PointCloud scattered(const tzc::Publisher& publisher, int number, std::size_t channels) {
  tzc::sensor_msgs::PointCloud cloud;
  cloud.header.frame_id = std::to_string(number);
  cloud.channels.resize(channels);
  publisher.allocate(cloud);
  for (std::size_t i = 0; i < channels; ++i) cloud.channels[i].values.assign(4, static_cast<float>(i));
  return cloud;
}

void talk(ros::NodeHandle& node, std::istringstream channels) {
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::PointCloud>(node, "cloud", 100, 64 << 20);
  while (ros::ok() && publisher.statistics().shared_subscribers == 0) ros::WallDuration(0.01).sleep();
  int number = 0;
  for (std::size_t count; channels >> count; ++number) publisher.publish(scattered(publisher, number, count));
  ros::WallDuration(1).sleep();
  const tzc::PublisherStatistics counted = publisher.statistics();
  std::printf("{\"shared\": %llu, \"serialized\": %llu, \"dropped\": %llu}\n",
              (unsigned long long)counted.shared, (unsigned long long)counted.serialized,
              (unsigned long long)counted.dropped);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "scattered");
  ros::NodeHandle node, options("~");
  if (options.param<std::string>("mode", "talk") == "talk") {
    talk(node, std::istringstream(options.param<std::string>("channels", "")));
  } else {
    const ros::Subscriber subscriber = tzc::subscribe(node, "cloud", 100, on_cloud);
    ros::spin();
  }
}
