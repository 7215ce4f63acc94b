// SPDX-License-Identifier: BSD-3-Clause
/// Publishes PCL clouds as they are, or listens to them as PointCloud2; lines as in image_line.h.
///
/// Private parameters: role (talker, listener). Talker: topic_type (cloud, message: what the topic is
/// advertised as; attached: as a message by other code, and then attached for clouds), pointer (publish by
/// pointer), count, points (of each cloud), memory (bytes). Listener: keep (all it gets), as_cloud (its
/// callback takes clouds), filter (the same, behind a filter).
#include <pcl/point_types.h>
#include <pcl_ros/point_cloud.h>
#include <ros/ros.h>
#include <tzc/memory.h>
#include <tzc/message_filters.h>
#include <tzc/pcl.h>
#include <tzc/ros.h>

#include <boost/make_shared.hpp>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud make_cloud(std::uint32_t number, std::uint32_t points) {
  Cloud cloud(points, 1);
  for (std::uint32_t i = 0; i < points; ++i)
    cloud.points[i] = pcl::PointXYZ(static_cast<float>(i), static_cast<float>(number), -1.5f);
  cloud.header.frame_id = std::to_string(number);
  return cloud;
}

bool is_right(const Cloud& cloud, std::uint32_t number) {
  for (std::uint32_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.points[i].x != static_cast<float>(i) || cloud.points[i].y != static_cast<float>(number))
      return false;
  return !cloud.points.empty();
}

void print(const Cloud& cloud, bool shared) {
  const auto number = static_cast<std::uint32_t>(std::stoul(cloud.header.frame_id));
  std::printf("{\"number\": %u, \"seq\": %u, \"right\": %s, \"shared\": %s}\n", number, cloud.header.seq,
              is_right(cloud, number) ? "true" : "false", shared ? "true" : "false");
  std::fflush(stdout);
}
void print(const sensor_msgs::PointCloud2& message) {
  Cloud cloud;
  pcl::fromROSMsg(message, cloud);
  print(cloud, tzc::in_segment(message.data.data()));
}

tzc::Publisher advertise(ros::NodeHandle& node, const ros::NodeHandle& options) {
  const int memory = options.param("memory", 0);
  if (options.param<std::string>("topic_type", "cloud") == "attached")
    return tzc::attach_publisher<Cloud>(node.advertise<sensor_msgs::PointCloud2>("points", 200), memory);
  if (options.param<std::string>("topic_type", "cloud") == "message")
    return tzc::advertise<tzc::sensor_msgs::PointCloud2>(node, "points", 200, memory);
  return tzc::advertise<Cloud>(node, "points", 200, memory);
}

void talk(ros::NodeHandle& node, const ros::NodeHandle& options) {
  const tzc::Publisher publisher = advertise(node, options);
  while (ros::ok() && publisher.statistics().shared_subscribers == 0) ros::WallDuration(0.002).sleep();
  const auto points = static_cast<std::uint32_t>(options.param("points", 1000));
  for (int number = 0; ros::ok() && number < options.param("count", 50); ++number) {
    const Cloud cloud = make_cloud(static_cast<std::uint32_t>(number), points);
    if (options.param("pointer", false))
      publisher.publish(boost::make_shared<Cloud>(cloud));
    else
      publisher.publish(cloud);
  }
  ros::WallDuration(0.5).sleep();  // stays until the queue is empty, as ordinary nodes do
  const tzc::PublisherStatistics s = publisher.statistics();
  std::printf("{\"copied_bytes\": %llu, \"serialized\": %llu, \"exhausted\": %llu, \"dropped\": %llu}\n",
              (unsigned long long)s.copied_bytes, (unsigned long long)s.serialized,
              (unsigned long long)s.exhausted, (unsigned long long)s.dropped);
  std::fflush(stdout);
}

void listen(ros::NodeHandle& node, const ros::NodeHandle& options) {
  const bool keeps = options.param("keep", false);
  std::vector<sensor_msgs::PointCloud2ConstPtr> kept;
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> take =
      [&](const sensor_msgs::PointCloud2ConstPtr& message) {
        print(*message);
        if (keeps) kept.push_back(message);
      };
  const boost::function<void(const boost::shared_ptr<Cloud const>&)> take_cloud =
      [](const boost::shared_ptr<Cloud const>& cloud) { print(*cloud, false); };
  ros::Subscriber subscriber;
  tzc::message_filters::Subscriber<Cloud> filter;
  if (options.param("filter", false)) {
    filter.registerCallback(take_cloud);
    filter.subscribe(node, "points", 200);
  } else if (options.param("as_cloud", false)) {
    subscriber = tzc::subscribe<Cloud>(node, "points", 200, take_cloud);
  } else {
    subscriber = tzc::subscribe<sensor_msgs::PointCloud2>(node, "points", 200, take);
  }
  ros::spin();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "clouds");
  ros::NodeHandle node, options("~");
  if (options.param<std::string>("role", "talker") == "listener")
    listen(node, options);
  else
    talk(node, options);
}
