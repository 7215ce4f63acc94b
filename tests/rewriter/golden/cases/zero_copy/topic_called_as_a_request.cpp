// A topic's message may be called as a part of a service; no service of that name is to be seen.
#include <ros/ros.h>
#include <sensor_msgs/ScanRequest.h>

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::ScanRequest>("requests", 1);
  sensor_msgs::ScanRequest request;
  request.data.resize(n);
  pub.publish(request);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/ScanRequest zero_copy 'requests'
// publish src/node.cpp:9 sensor_msgs/ScanRequest zero_copy 'requests'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/ScanRequest.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::ScanRequest>("requests", 1);
// -  sensor_msgs::ScanRequest request;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::ScanRequest>(nh, "requests", 1);
// +  tzc::sensor_msgs::ScanRequest request;
// +  pub.allocate(request);
