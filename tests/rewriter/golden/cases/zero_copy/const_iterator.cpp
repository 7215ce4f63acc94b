// A const iterator reads the cloud that is built.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.resize(100);
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  cloud.width = *x;
  pub.publish(cloud);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/PointCloud2 zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// -  sensor_msgs::PointCloud2 cloud;
// -  sensor_msgs::PointCloud2Modifier modifier(cloud);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// +  tzc::sensor_msgs::PointCloud2 cloud;
// +  pub.allocate(cloud);
// +  tzc::sensor_msgs::PointCloud2Modifier modifier(cloud);
// -  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
// +  tzc::sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
