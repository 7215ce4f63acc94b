// One macro makes two calls, nested ones among them: each is a site of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define SEND(publisher, message) publisher.publish(message)
#define SEND_BOTH(left, right)         \
  do {                                 \
    SEND(left_pub, left);              \
    SEND(right_pub, right);            \
  } while (false)

void run(ros::NodeHandle& nh) {
  ros::Publisher left_pub = nh.advertise<sensor_msgs::Image>("left", 1);
  ros::Publisher right_pub = nh.advertise<sensor_msgs::Image>("right", 1);
  sensor_msgs::Image left, right;
  left.data.resize(640 * 480);
  right.data.resize(640 * 480);
  SEND_BOTH(left, right);
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'right'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher left_pub = nh.advertise<sensor_msgs::Image>("left", 1);
// -  ros::Publisher right_pub = nh.advertise<sensor_msgs::Image>("right", 1);
// -  sensor_msgs::Image left, right;
// +  tzc::Publisher left_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "left", 1);
// +  tzc::Publisher right_pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "right", 1);
// +  tzc::sensor_msgs::Image left, right;
// +  tzc::allocate(left);
// +  tzc::allocate(right);
