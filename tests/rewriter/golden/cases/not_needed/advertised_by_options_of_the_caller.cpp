// Its advertise call has an obstacle, but nothing that is published with it is large.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#define ADVERTISED(nh, topic) nh.advertise<sensor_msgs::Image>(topic, 1)

void unknown(ros::NodeHandle& nh, ros::AdvertiseOptions& options) {
  ros::Publisher pub = nh.advertise(options);
  pub.publish(std_msgs::Header());
}
void by_macro(ros::NodeHandle& nh) {
  ros::Publisher pub = ADVERTISED(nh, "image");
  sensor_msgs::Image empty;
  pub.publish(empty);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image not_needed what is published with it needs no shared memory
// publish src/node.cpp:10 std_msgs/Header not_needed
// advertise src/node.cpp:13 sensor_msgs/Image not_needed 'image' what is published with it needs no shared memory
// publish src/node.cpp:15 sensor_msgs/Image not_needed 'image' no array of it that shared memory can hold is filled
