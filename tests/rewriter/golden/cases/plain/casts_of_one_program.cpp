// Two programs of one package: what one of them does with its messages, the other one does not see.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<uint8_t> kept;
void on_image(const sensor_msgs::ImageConstPtr& image) { kept.swap(const_cast<sensor_msgs::Image&>(*image).data); }
void clear(void* user) { static_cast<sensor_msgs::Image*>(user)->data.clear(); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("image", 1, on_image);
  ros::spin();
}
//--- src/viewer.cpp
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void on_image(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("image", 1, on_image);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
// subscribe src/viewer.cpp:8 sensor_msgs/Image shared 'image'
//
// +++ src/viewer.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber subscriber = nh.subscribe("image", 1, on_image);
// +  ros::Subscriber subscriber = tzc::subscribe(nh, "image", 1, on_image);
