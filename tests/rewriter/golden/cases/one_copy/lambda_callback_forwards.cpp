// A lambda callback forwards.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 1);
  ros::Subscriber sub =
      nh.subscribe<sensor_msgs::Image>("in", 1, [&pub](const sensor_msgs::ImageConstPtr& image) { pub.publish(image); });
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'in'
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'lambda'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
// -      nh.subscribe<sensor_msgs::Image>("in", 1, [&pub](const sensor_msgs::ImageConstPtr& image) { pub.publish(image); });
// +      tzc::subscribe<sensor_msgs::Image>(nh, "in", 1, [&pub](const sensor_msgs::ImageConstPtr& image) { pub.publish(image); });
