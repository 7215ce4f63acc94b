// Through another name of the array: the pointer comes first, then the index publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;
sensor_msgs::Image image;

int send() {
  pub.publish(image);
  return 3;
}

void run(ros::NodeHandle& nh) {
  pub = nh.advertise<sensor_msgs::Image>("image", 10);
  image.data.resize(100);
  auto& pixels = image.data;
  pixels.data()[send()] = 1;
}
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after the message may have been published
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
