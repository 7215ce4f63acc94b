// SubscribeOptions that come from elsewhere: left alone.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, ros::SubscribeOptions& options) {
  ros::Subscriber sub = nh.subscribe(options);
}
//--- expected
// subscribe src/node.cpp:6  plain TZC2006 no message type is to be seen in this call
