// A function of pcl_conversions without an adapter.
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  pcl::PCLPointCloud2 cloud;
  sensor_msgs::PointCloud2 message;
  pcl_conversions::copyPCLPointCloud2MetaData(cloud, message);
  message.data.resize(10);
  pub.publish(message);
  pcl::PCLImage pcl_image;
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  pcl_conversions::copyPCLImageMetaData(pcl_image, image);
  image.data.resize(10);
  images.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/PointCloud2 one_copy 'image' TZC1002 it is passed to 'pcl_conversions::copyPCLPointCloud2MetaData', which is not part of the package
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1002 it is passed to 'pcl_conversions::copyPCLImageMetaData', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::PointCloud2>(nh, "image", 10);
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher images = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
