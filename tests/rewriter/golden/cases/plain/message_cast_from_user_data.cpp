// What lies behind a void pointer may be a received message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void on_image(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
void clear(void* user) { static_cast<sensor_msgs::Image*>(user)->data.clear(); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("image", 1, on_image);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image plain 'image' TZC2002 a message that may be this one is cast from 'void *', which does not tell what lies there
