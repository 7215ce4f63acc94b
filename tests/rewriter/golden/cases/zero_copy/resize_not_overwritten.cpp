// What stands between resize and the copy may leave the function, or the copy reads what resize made, or it fills another array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstring>

uint32_t grab();

void run(ros::NodeHandle& nh, const uint8_t* pixels, unsigned n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image, other, third;
  image.data.resize(100);
  image.step = grab();
  memcpy(&image.data[0], pixels, 100);
  pub.publish(image);
  image.data.clear();
  image.data.resize(n);
  std::fill(image.data.begin(), image.data.end(), image.data[0]);
  pub.publish(image);
  other.data.clear();
  sensor_msgs::Image* chosen = &other;
  third.data.resize(100);
  chosen->data.resize(100);
  chosen = &third;
  memcpy(&chosen->data[0], pixels, 100);
  pub.publish(other);
  image.data.clear();
  image.data.resize(n);
  auto& same = image.data;
  std::fill(image.data.begin(), image.data.end(), same[0]);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image, other, third;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image, other, third;
// +  pub.allocate(image);
// +  pub.allocate(other);
// +  pub.allocate(third);
// -  sensor_msgs::Image* chosen = &other;
// +  tzc::sensor_msgs::Image* chosen = &other;
