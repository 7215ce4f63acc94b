// PointCloud2 iterators used after the publish.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.resize(100);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  pub.publish(cloud);
  *x = 0;
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/PointCloud2 one_copy 'image' TZC1003 'x' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::PointCloud2>(nh, "image", 10);
