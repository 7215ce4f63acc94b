// pcl_conversions::moveFromPCL: the elements are those of the cloud's vector.
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
  pcl::PCLPointCloud2 cloud;
  sensor_msgs::PointCloud2 moved;
  pcl_conversions::moveFromPCL(cloud, moved);
  pub.publish(moved);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/PointCloud2 one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/PointCloud2 one_copy 'image' TZC1022 line 9 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud2>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "image", 10);
// -  sensor_msgs::PointCloud2 moved;
// -  pcl_conversions::moveFromPCL(cloud, moved);
// +  tzc::sensor_msgs::PointCloud2 moved;
// +  pub.allocate(moved);
// +  tzc::pcl_conversions::moveFromPCL(cloud, moved);
