// The last number that is light, a product, a sizeof, elements of a class type.
//RUN: small=4096
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <visualization_msgs/Marker.h>

void line(ros::NodeHandle& nh, const geometry_msgs::Point& from, const geometry_msgs::Point& to) {
  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("marker", 10);
  visualization_msgs::Marker marker;
  marker.points.push_back(from);
  marker.points.push_back(to);
  pub.publish(marker);
}

void corners(ros::NodeHandle& nh, bool more) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan scan;
  scan.ranges.resize(511 + sizeof(char));
  scan.intensities.assign(511, 0);
  if (more) scan.ranges[0] = scan.intensities.front();
  scan.ranges.pop_back();
  pub.publish(scan);
  sensor_msgs::LaserScan cleared;
  cleared.ranges = {};
  cleared.intensities = std::vector<float>();
  pub.publish(cleared);
}
//--- expected
// advertise src/node.cpp:8 visualization_msgs/Marker not_needed 'marker' what is published with it needs no shared memory
// publish src/node.cpp:12 visualization_msgs/Marker not_needed 'marker' its arrays hold at most 48 bytes
// advertise src/node.cpp:16 sensor_msgs/LaserScan not_needed 'scan' what is published with it needs no shared memory
// publish src/node.cpp:22 sensor_msgs/LaserScan not_needed 'scan' its arrays hold at most 4092 bytes
// publish src/node.cpp:26 sensor_msgs/LaserScan not_needed 'scan' its arrays hold at most 0 bytes
