// What is never published is given as a stock copy to a function that takes stock messages, too.
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

bool test() {
  sensor_msgs::Image image;
  fill(5, image);
  if (image.width > 3) return false;
  return is_empty(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(unsigned size, sensor_msgs::Image& image) { image.data.resize(size); }
// +void fill(unsigned size, tzc::sensor_msgs::Image& image) { image.data.resize(size); }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  sensor_msgs::Image image_stock;
// -  return is_empty(image);
// +  return is_empty(image_stock = tzc::message::to_stock(image));
