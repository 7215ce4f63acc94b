// The factory is also called where no publisher is known.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image make() {
  sensor_msgs::Image image;
  image.data.resize(10);
  return image;
}

unsigned size() { return make().data.size(); }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(make());
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub' is a variable of another function
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
