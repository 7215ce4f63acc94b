// Two names of one object: a pointer that was got by one of them must not be left behind by what is done to the other one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Channel {
  ros::Publisher pub;
  sensor_msgs::Image frame;
};

void emit(Channel* channel) {
  Channel& same = *channel;
  unsigned char* pixels = same.frame.data.data();
  channel->frame.header.stamp = ros::Time::now();
  for (int i = 0; i < 10; ++i) pixels[i] = i;
  channel->pub.publish(channel->frame);
}

void open(ros::NodeHandle& nh, Channel& channel) {
  channel.pub = nh.advertise<sensor_msgs::Image>("image", 1);
  channel.frame.data.resize(10);
}
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub;
// -  sensor_msgs::Image frame;
// +  tzc::Publisher pub;
// +  tzc::sensor_msgs::Image frame;
// -  channel.pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  channel.pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
