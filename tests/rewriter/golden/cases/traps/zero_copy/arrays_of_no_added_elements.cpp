// No element with an array of its own is added: all of the content lies in shared memory.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>

ros::Publisher plain, cleared, read;

void publish_plain(int n) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(n);
  plain.publish(cloud);
}

void publish_cleared(int n) {
  sensor_msgs::PointCloud cloud;
  cloud.channels.resize(3);
  cloud.channels.clear();
  cloud.points.resize(n);
  cleared.publish(cloud);
}

std::size_t publish_read(int n) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(n);
  read.publish(cloud);
  return cloud.channels.size();
}

int main() {
  ros::NodeHandle nh;
  plain = nh.advertise<sensor_msgs::PointCloud>("plain", 10);
  cleared = nh.advertise<sensor_msgs::PointCloud>("cleared", 10);
  read = nh.advertise<sensor_msgs::PointCloud>("read", 10);
}
//--- expected
// publish src/node.cpp:10 sensor_msgs/PointCloud zero_copy 'plain'
// publish src/node.cpp:18 sensor_msgs/PointCloud zero_copy 'cleared'
// publish src/node.cpp:24 sensor_msgs/PointCloud zero_copy 'read'
// advertise src/node.cpp:30 sensor_msgs/PointCloud zero_copy 'plain'
// advertise src/node.cpp:31 sensor_msgs/PointCloud zero_copy 'cleared'
// advertise src/node.cpp:32 sensor_msgs/PointCloud zero_copy 'read'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -ros::Publisher plain, cleared, read;
// +tzc::Publisher plain, cleared, read;
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  plain.allocate(cloud);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  cleared.allocate(cloud);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  read.allocate(cloud);
// -  plain = nh.advertise<sensor_msgs::PointCloud>("plain", 10);
// -  cleared = nh.advertise<sensor_msgs::PointCloud>("cleared", 10);
// -  read = nh.advertise<sensor_msgs::PointCloud>("read", 10);
// +  plain = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "plain", 10);
// +  cleared = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "cleared", 10);
// +  read = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "read", 10);
