// What is published is no message type that the compiler knows: nobody knows its arrays.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct AnyMessage {
  int number;
};

void run(ros::NodeHandle& nh, const AnyMessage& message) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("any", 1);
  pub.publish(message);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image not_needed 'any' nobody knows the arrays of what is published with it
// publish src/node.cpp:11 const AnyMessage plain 'any' TZC1012 the type of what is published is 'const AnyMessage'
