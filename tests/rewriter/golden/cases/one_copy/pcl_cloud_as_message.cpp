// A PCL cloud on a PointCloud2 topic.
#include <pcl_ros/point_cloud.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pub.publish(cloud);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/PointCloud2 one_copy 'image'
// publish src/node.cpp:7 sensor_msgs/PointCloud2 one_copy 'image' its elements lie in memory of its library, and publishing copies them
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::PointCloud2>(nh, "image", 10);
