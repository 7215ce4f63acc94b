// pcl_conversions::fromPCL.
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  pcl::PCLPointCloud2 cloud;
  sensor_msgs::PointCloud2 a;
  pcl_conversions::fromPCL(cloud, a);
  pub.publish(a);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/PointCloud2 zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// -  sensor_msgs::PointCloud2 a;
// -  pcl_conversions::fromPCL(cloud, a);
// +  tzc::sensor_msgs::PointCloud2 a;
// +  pub.allocate(a);
// +  tzc::pcl_conversions::fromPCL(cloud, a);
