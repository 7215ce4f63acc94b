// Two files that have main(): a third one has the code of both, and what one callback takes away, the other one has not.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static std::vector<uint8_t> kept;
static void take(const sensor_msgs::ImageConstPtr& image) {
  kept.swap(const_cast<sensor_msgs::Image&>(*image).data);
}

int main() {
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("image", 1, take);
  ros::spin();
}
//--- src/viewer.cpp
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static void look(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("image", 1, look);
  ros::spin();
}
//--- src/both.cpp
#define main take_main
#include "node.cpp"
#undef main
#define main look_main
#include "viewer.cpp"
#undef main

int main() {
  take_main();
  look_main();
}
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
// subscribe src/viewer.cpp:8 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it, by a callback of another subscription to its type, which may have the same topic
