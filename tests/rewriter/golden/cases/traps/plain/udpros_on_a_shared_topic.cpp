// roscpp subscribes to a topic once, by the hints of the first callback: one that asks for UDPROS gets the message of the other.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<uint8_t> kept;
void look(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
void take(const sensor_msgs::ImageConstPtr& image) { kept.swap(const_cast<sensor_msgs::Image&>(*image).data); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber looks = nh.subscribe("image", 1, look);
  ros::Subscriber takes = nh.subscribe("image", 1, take, ros::TransportHints().unreliable());
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it, by a callback of another subscription to its type, which may have the same topic
// subscribe src/node.cpp:14 sensor_msgs/Image not_needed 'image' it asks for UDPROS
