// pcl::toROSMsg with using namespace pcl, into *pointer.
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>

using namespace pcl;

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  sensor_msgs::PointCloud2Ptr message(new sensor_msgs::PointCloud2);
  toROSMsg(*cloud, *message);
  pub.publish(message);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/PointCloud2 zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/PointCloud2 zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// -  sensor_msgs::PointCloud2Ptr message(new sensor_msgs::PointCloud2);
// -  toROSMsg(*cloud, *message);
// +  tzc::sensor_msgs::PointCloud2Ptr message(new tzc::sensor_msgs::PointCloud2);
// +  pub.allocate(*message);
// +  tzc::pcl::toROSMsg(*cloud, *message);
