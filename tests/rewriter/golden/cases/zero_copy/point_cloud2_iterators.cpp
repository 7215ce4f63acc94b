// PointCloud2Modifier and iterators.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  sensor_msgs::PointCloud2Ptr cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  sensor_msgs::PointCloud2Modifier modifier(*cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(100);
  sensor_msgs::PointCloud2Iterator<float> x(*cloud, "x"), y(*cloud, "y");
  for (; x != x.end(); ++x, ++y) *x = *y = 0;
  pub.publish(cloud);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/PointCloud2 zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// -  sensor_msgs::PointCloud2Ptr cloud = boost::make_shared<sensor_msgs::PointCloud2>();
// -  sensor_msgs::PointCloud2Modifier modifier(*cloud);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// +  tzc::sensor_msgs::PointCloud2Ptr cloud = boost::make_shared<tzc::sensor_msgs::PointCloud2>();
// +  pub.allocate(*cloud);
// +  tzc::sensor_msgs::PointCloud2Modifier modifier(*cloud);
// -  sensor_msgs::PointCloud2Iterator<float> x(*cloud, "x"), y(*cloud, "y");
// +  tzc::sensor_msgs::PointCloud2Iterator<float> x(*cloud, "x"), y(*cloud, "y");
