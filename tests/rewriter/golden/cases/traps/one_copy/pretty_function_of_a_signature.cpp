// The text has the types of the parameters, and is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(ros::Publisher& pub, sensor_msgs::Image& image) {
  image.data.resize(100);
  image.encoding = __PRETTY_FUNCTION__;
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  send(pub, image);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for the text of its function's signature
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1010 the program asks for the text of its function's signature
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 1));
