// A weak function gives way to another one where the program is linked, which may keep what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void watch(uint8_t* first, size_t n);
__attribute__((weak)) void watch(uint8_t*, size_t) {}

#pragma weak note
void note(uint8_t*) {}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("watched", 1);
  static sensor_msgs::Image image;
  while (ros::ok()) {
    image.data.resize(100);
    watch(image.data.data(), image.data.size());
    pub.publish(image);
  }
}

void run_noted(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("noted", 1);
  static sensor_msgs::Image image;
  while (ros::ok()) {
    image.data.resize(100);
    note(&image.data[0]);
    pub.publish(image);
  }
}

__attribute__((weak)) void send(ros::Publisher& pub, sensor_msgs::Image& sent) {
  sent.data.resize(100);
  pub.publish(sent);
}

void run_sent(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("sent", 1);
  sensor_msgs::Image image;
  send(pub, image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'watched'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'watched' TZC1003 a pointer into its data is passed to 'watch'
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'noted'
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'noted' TZC1022 line 26 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'sent' TZC1005 'send' may have another body where it is linked
// advertise src/node.cpp:37 sensor_msgs/Image one_copy 'sent' TZC1005 'send' may have another body where it is linked
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("watched", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "watched", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("noted", 1);
// -  static sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "noted", 1);
// +  static tzc::sensor_msgs::Image image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("sent", 1);
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("sent", 1));
