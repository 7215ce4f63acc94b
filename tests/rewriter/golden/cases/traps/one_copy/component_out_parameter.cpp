// A function keeps a pointer into what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static uint8_t* kept = nullptr;
void fill(sensor_msgs::Image& image) {
  kept = &image.data[0];
}
void write() {
  *kept = 1;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  fill(image);
  pub.publish(image);
  write();
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'kept'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
