// pcl::toROSMsg into a local message.
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  sensor_msgs::PointCloud2 message;
  pcl::toROSMsg(cloud, message);
  message.header.frame_id = "map";
  pub.publish(message);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/PointCloud2 zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// -  sensor_msgs::PointCloud2 message;
// -  pcl::toROSMsg(cloud, message);
// +  tzc::sensor_msgs::PointCloud2 message;
// +  pub.allocate(message);
// +  tzc::pcl::toROSMsg(cloud, message);
