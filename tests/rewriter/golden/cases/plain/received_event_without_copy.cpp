// An event that is told not to copy gives out the received message itself, to be written to.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

void image(const ros::MessageEvent<sensor_msgs::Image const>& event) {
  ros::MessageEvent<sensor_msgs::Image> mine(event, false);
  mine.getMessage()->data.resize(5);
}

void cloud(const ros::MessageEvent<sensor_msgs::PointCloud2 const>& event) {
  const bool copies = event.nonConstWillCopy() && false;
  ros::MessageEvent<sensor_msgs::PointCloud2> mine(
      event.getMessage(), ros::Time(), copies, [] { return boost::make_shared<sensor_msgs::PointCloud2>(); });
  mine.getMessage()->data.resize(5);
}

void scan(const ros::MessageEvent<sensor_msgs::LaserScan const>& event) {
  std::vector<ros::MessageEvent<sensor_msgs::LaserScan>> all;
  all.emplace_back(event, false);
  all[0].getMessage()->ranges.resize(5);
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe("a", 1, image);
  ros::Subscriber b = nh.subscribe("b", 1, cloud);
  ros::Subscriber c = nh.subscribe("c", 1, scan);
}
//--- expected
// subscribe src/node.cpp:28 sensor_msgs/Image plain 'a' TZC2002 a ros::MessageEvent is told to give out the message without a copy
// subscribe src/node.cpp:29 sensor_msgs/PointCloud2 plain 'b' TZC2002 a ros::MessageEvent is told to give out the message without a copy
// subscribe src/node.cpp:30 sensor_msgs/LaserScan plain 'c' TZC2002 a ros::MessageEvent is told to give out the message without a copy
