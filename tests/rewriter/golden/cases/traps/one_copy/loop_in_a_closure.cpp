// The loop of a closure goes round: what it writes at its start is written after what it published at its end.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void step(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("loop", 1);
  [&] {
    sensor_msgs::Image image;
    image.data.resize(100);
    for (int turn = 0; turn < 3; ++turn) {
      image.data[turn] = 1;
      pub.publish(image);
    }
  }();
}
void new_each_time(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new_each_time", 1);
  [&] {
    for (int turn = 0; turn < 3; ++turn) {
      sensor_msgs::Image image;
      image.data.resize(100);
      image.data[turn] = 1;
      pub.publish(image);
    }
  }();
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'loop'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'loop' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'new_each_time'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'new_each_time'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("loop", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "loop", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new_each_time", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "new_each_time", 1);
// -      sensor_msgs::Image image;
// +      tzc::sensor_msgs::Image image;
// +      pub.allocate(image);
