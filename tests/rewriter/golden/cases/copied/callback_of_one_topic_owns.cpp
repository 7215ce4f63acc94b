// Where one callback of a topic takes the message as its own, all of them get copies.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void look(const sensor_msgs::ImageConstPtr&) {}
void draw(const sensor_msgs::ImagePtr&) {}

int main() {
  ros::NodeHandle nh;
  ros::Subscriber looking = nh.subscribe("image", 1, look);
  ros::Subscriber drawing = nh.subscribe("image", 1, draw);
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image copied 'image' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:11 sensor_msgs/Image copied 'image' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber looking = nh.subscribe("image", 1, look);
// -  ros::Subscriber drawing = nh.subscribe("image", 1, draw);
// +  ros::Subscriber looking = tzc::subscribe(nh, "image", 1, look);
// +  ros::Subscriber drawing = tzc::subscribe(nh, "image", 1, draw);
