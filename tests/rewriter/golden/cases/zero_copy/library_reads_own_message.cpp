// Functions of a library that read a message which is published, too.
#include <cv_bridge/cv_bridge.h>
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void save(const cv_bridge::CvImagePtr& image);

void images(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(6000);
  save(cv_bridge::toCvCopy(image, "bgr8"));
  pub.publish(image);
  save(cv_bridge::toCvCopy(*image));
}

void clouds(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
  sensor_msgs::PointCloud2 message;
  message.data.resize(6000);
  pub.publish(message);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromROSMsg(message, cloud);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:19 sensor_msgs/PointCloud2 zero_copy 'cloud'
// publish src/node.cpp:22 sensor_msgs/PointCloud2 zero_copy 'cloud'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
// -  save(cv_bridge::toCvCopy(image, "bgr8"));
// +  save(tzc::cv_bridge::toCvCopy(image, "bgr8"));
// -  save(cv_bridge::toCvCopy(*image));
// +  save(tzc::cv_bridge::toCvCopy(*image));
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
// -  sensor_msgs::PointCloud2 message;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "cloud", 1);
// +  tzc::sensor_msgs::PointCloud2 message;
// +  pub.allocate(message);
// -  pcl::fromROSMsg(message, cloud);
// +  tzc::pcl::fromROSMsg(message, cloud);
