// allocate binds the arrays that a message has; those of elements that are added afterwards lie outside shared memory.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>

ros::Publisher resized, pushed, assigned, referred;

void resize(int n) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(n);
  cloud.channels.resize(1);
  cloud.channels[0].values.resize(n);
  resized.publish(cloud);
}

void push(const sensor_msgs::ChannelFloat32& channel) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(10);
  cloud.channels.push_back(channel);
  pushed.publish(cloud);
}

void assign(const std::vector<sensor_msgs::ChannelFloat32>& channels) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(10);
  for (const auto& channel : channels) cloud.channels.emplace_back().name = channel.name;
  assigned.publish(cloud);
}

void refer(int n) {
  sensor_msgs::PointCloud cloud;
  auto& channels = cloud.channels;
  cloud.points.resize(n);
  channels.resize(2);
  referred.publish(cloud);
}

int main() {
  ros::NodeHandle nh;
  resized = nh.advertise<sensor_msgs::PointCloud>("resized", 10);
  pushed = nh.advertise<sensor_msgs::PointCloud>("pushed", 10);
  assigned = nh.advertise<sensor_msgs::PointCloud>("assigned", 10);
  referred = nh.advertise<sensor_msgs::PointCloud>("referred", 10);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/PointCloud one_copy 'resized' TZC1022 line 10 gives it elements that lie outside shared memory
// publish src/node.cpp:19 sensor_msgs/PointCloud one_copy 'pushed' TZC4004 'sensor_msgs/ChannelFloat32' has no TZC header
// publish src/node.cpp:26 sensor_msgs/PointCloud one_copy 'assigned' TZC1022 line 25 gives it elements that lie outside shared memory
// publish src/node.cpp:34 sensor_msgs/PointCloud one_copy 'referred' TZC4004 'sensor_msgs/ChannelFloat32' has no TZC header
// advertise src/node.cpp:39 sensor_msgs/PointCloud one_copy 'resized'
// advertise src/node.cpp:40 sensor_msgs/PointCloud one_copy 'pushed'
// advertise src/node.cpp:41 sensor_msgs/PointCloud one_copy 'assigned'
// advertise src/node.cpp:42 sensor_msgs/PointCloud one_copy 'referred'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -ros::Publisher resized, pushed, assigned, referred;
// +tzc::Publisher resized, pushed, assigned, referred;
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  resized.allocate(cloud);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  assigned.allocate(cloud);
// -  resized = nh.advertise<sensor_msgs::PointCloud>("resized", 10);
// -  pushed = nh.advertise<sensor_msgs::PointCloud>("pushed", 10);
// -  assigned = nh.advertise<sensor_msgs::PointCloud>("assigned", 10);
// -  referred = nh.advertise<sensor_msgs::PointCloud>("referred", 10);
// +  resized = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "resized", 10);
// +  pushed = tzc::advertise<sensor_msgs::PointCloud>(nh, "pushed", 10);
// +  assigned = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "assigned", 10);
// +  referred = tzc::advertise<sensor_msgs::PointCloud>(nh, "referred", 10);
