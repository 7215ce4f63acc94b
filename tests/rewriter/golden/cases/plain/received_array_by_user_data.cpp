// An array of a received message loses its type, and what has none becomes an array.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

const void* last;
void trim() { ((std::vector<uint8_t>*)last)->resize(30000); }
void on_image(const sensor_msgs::ImageConstPtr& image) {
  last = &image->data;
  trim();
}

void run(ros::NodeHandle& nh) { ros::Subscriber images = nh.subscribe("image", 1, on_image); }
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain 'image' TZC2002 an array that may be one of this message's is cast from 'const void *', which does not tell what lies there
