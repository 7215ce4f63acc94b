// No array of the message is ever filled.
#include <ros/ros.h>
#include <visualization_msgs/Marker.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<visualization_msgs::Marker>("image", 10);
  visualization_msgs::Marker marker;
  marker.type = 1;
  marker.text = "arrow";
  pub.publish(marker);
}
//--- expected
// advertise src/node.cpp:6 visualization_msgs/Marker not_needed 'image' what is published with it needs no shared memory
// publish src/node.cpp:10 visualization_msgs/Marker not_needed 'image' no array of it that shared memory can hold is filled
