// A global message that a function declares for itself.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send();
void draw() {
  extern sensor_msgs::Image g_image;
  uint8_t* first = &g_image.data[0];
  send();
  *first = 1;
}

sensor_msgs::Image g_image;
ros::Publisher g_pub;
void send() {
  g_pub.publish(g_image);
}
void init(ros::NodeHandle& nh) {
  g_pub = nh.advertise<sensor_msgs::Image>("image", 10);
}
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher g_pub;
// +tzc::Publisher g_pub;
// -  g_pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  g_pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
