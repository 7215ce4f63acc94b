// A weak function gives way to another one where the program is linked, which may keep what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void watch(uint8_t* first, size_t n);
__attribute__((weak)) void watch(uint8_t*, size_t) {}

#pragma weak note
void note(uint8_t*) {}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("watched", 1);
  while (ros::ok()) {
    sensor_msgs::Image image;
    image.data.resize(100);
    watch(image.data.data(), image.data.size());
    pub.publish(image);
  }
}

void run_noted(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("noted", 1);
  while (ros::ok()) {
    sensor_msgs::Image image;
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
