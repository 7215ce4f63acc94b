// Two subscriptions may have one topic, whose callbacks get one message: what one of them takes away, the other has not.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<uint8_t> kept;

void look(const sensor_msgs::ImageConstPtr&) {}
void steal(const sensor_msgs::ImageConstPtr& image) { kept.swap(const_cast<sensor_msgs::Image&>(*image).data); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber looking = nh.subscribe("image", 1, look);
  ros::Subscriber stealing = nh.subscribe("image", 1, steal);
}
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it, by a callback of another subscription to its type, which may have the same topic
// subscribe src/node.cpp:15 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
