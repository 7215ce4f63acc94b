// As pointer_into_moved_to_heap.cpp, but the message that gives its elements was allocated itself.
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void of_new(ros::NodeHandle& nh, int k) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new", 1);
  sensor_msgs::Image built;
  built.data.resize(6000);
  uint8_t* first = &built.data[0];
  sensor_msgs::ImagePtr image(new sensor_msgs::Image(std::move(built)));
  first[1] = k;
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  for (int k = 0; k < 9; ++k) of_new(nh, k);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'new'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'new'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new", 1);
// -  sensor_msgs::Image built;
// +  static tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "new", 1);
// +  tzc::sensor_msgs::Image built;
// +  pub.allocate(built);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image(std::move(built)));
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image(std::move(built)));
