// A type without arrays needs nothing.
#include <ros/ros.h>
#include <std_msgs/String.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<std_msgs::String>("image", 10);
  std_msgs::String text;
  text.data = "x";
  pub.publish(text);
}
//--- expected
// advertise src/node.cpp:6 std_msgs/String not_needed 'image'
// publish src/node.cpp:9 std_msgs/String not_needed 'image'
