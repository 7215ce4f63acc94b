// What a function does not follow says nothing about another function's own messages.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <functional>

struct Pool {
  void put(sensor_msgs::Image* image) { image->data.clear(); }
};

std::function<void(sensor_msgs::Image&)> release;

void pooled(ros::NodeHandle& nh, Pool& pool, sensor_msgs::Image& last) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("pooled", 1);
  release = [&pool](sensor_msgs::Image& old) { pool.put(&old); };
  pub.publish(last);
}

sensor_msgs::Image kept;
void lasting(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("lasting", 1);
  kept.data.clear();
  kept.data.resize(100);
  pub.publish(kept);
}

void listed(ros::NodeHandle& nh) {
  ros::Publisher left_pub = nh.advertise<sensor_msgs::Image>("left", 1);
  ros::Publisher right_pub = nh.advertise<sensor_msgs::Image>("right", 1);
  sensor_msgs::Image left, right;
  for (sensor_msgs::Image* image : {&left, &right}) image->data.resize(100);
  left_pub.publish(left);
  right_pub.publish(right);
}

void clean(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("clean", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'pooled'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'pooled' TZC1019 no call that gives 'last' a message was found
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'lasting'
// publish src/node.cpp:24 sensor_msgs/Image one_copy 'lasting' TZC1022 line 15 of node.cpp uses a sensor_msgs/Image, and nothing shows which: it may be this one, and be written to after this publish
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:29 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'right'
// advertise src/node.cpp:37 sensor_msgs/Image zero_copy 'clean'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'clean'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("pooled", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "pooled", 1);
// -sensor_msgs::Image kept;
// +tzc::sensor_msgs::Image kept;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("lasting", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "lasting", 1);
// -  ros::Publisher left_pub = nh.advertise<sensor_msgs::Image>("left", 1);
// -  ros::Publisher right_pub = nh.advertise<sensor_msgs::Image>("right", 1);
// -  sensor_msgs::Image left, right;
// -  for (sensor_msgs::Image* image : {&left, &right}) image->data.resize(100);
// +  tzc::Publisher left_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "left", 1);
// +  tzc::Publisher right_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "right", 1);
// +  tzc::sensor_msgs::Image left, right;
// +  left_pub.allocate(left);
// +  right_pub.allocate(right);
// +  for (tzc::sensor_msgs::Image* image : {&left, &right}) image->data.resize(100);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("clean", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "clean", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
