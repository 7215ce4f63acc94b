// Two files that have main(), compiled for shared libraries: a program with a main() of its own may have both.
//RUN: flags=-fPIC
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
//--- expected
// subscribe src/node.cpp:15 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
// subscribe src/viewer.cpp:8 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it, by a callback of another subscription to its type, which may have the same topic
