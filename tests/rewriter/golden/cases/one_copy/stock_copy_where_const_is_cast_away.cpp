// A function that casts const away would write to the copy.
#include <other/library.h>

void fill(unsigned size, sensor_msgs::Image& image) { image.data.resize(size); }
bool is_empty(const sensor_msgs::Image& image) {
  const_cast<sensor_msgs::Image&>(image).data.clear();
  return image.data.empty();
}
void look() {
  const sensor_msgs::Image seen = other::grab();
  is_empty(seen);
}

void publish(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  fill(10000, image);
  pub.publish(image);
}

bool test() {
  sensor_msgs::Image image;
  fill(5, image);
  return is_empty(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'other::grab()', which code outside the package builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
