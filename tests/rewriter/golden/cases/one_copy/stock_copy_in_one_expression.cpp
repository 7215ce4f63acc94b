// The message may be written to in the expression that looks at it.
#include <other/library.h>

void fill(unsigned size, sensor_msgs::Image& image) { image.data.resize(size); }
bool is_empty(const sensor_msgs::Image& image) { return image.data.empty(); }
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

bool both(bool a, bool b) { return a && b; }
bool refill(sensor_msgs::Image& image) {
  fill(3, image);
  return true;
}
bool test() {
  sensor_msgs::Image image;
  return both(refill(image), is_empty(image));
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'other::grab()', which code outside the package builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
