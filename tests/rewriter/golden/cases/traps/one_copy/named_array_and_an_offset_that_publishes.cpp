// The same by pointer arithmetic, in a function that is given the array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;
sensor_msgs::Image image;

int send() {
  pub.publish(image);
  return 3;
}

template <class Pixels>
void mark(Pixels& pixels) {
  *(pixels.begin() + send()) = 1;
}

void run(ros::NodeHandle& nh) {
  pub = nh.advertise<sensor_msgs::Image>("image", 10);
  image.data.resize(100);
  mark(image.data);
}
//--- expected
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after the message may have been published
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
