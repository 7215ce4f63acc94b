// One message for all turns of a loop.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  while (ros::ok()) {
    image.data[0]++;
    pub.publish(image);
  }
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1022 line 10 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
