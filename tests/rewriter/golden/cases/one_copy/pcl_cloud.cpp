// A PCL cloud published as such.
#include <pcl_ros/point_cloud.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<pcl::PointCloud<pcl::PointXYZ>>("points", 1);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->push_back(pcl::PointXYZ());
  pub.publish(cloud);
  pub.publish(*cloud);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/PointCloud2 one_copy 'points'
// publish src/node.cpp:8 sensor_msgs/PointCloud2 one_copy 'points' its elements lie in memory of its library, and publishing copies them
// publish src/node.cpp:9 sensor_msgs/PointCloud2 one_copy 'points' its elements lie in memory of its library, and publishing copies them
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<pcl::PointCloud<pcl::PointXYZ>>("points", 1);
// +  tzc::Publisher pub = tzc::advertise<pcl::PointCloud<pcl::PointXYZ>>(nh, "points", 1);
