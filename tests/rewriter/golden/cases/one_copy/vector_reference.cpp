// A reference to the vector.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  std::vector<uint8_t>& data = image.data;
  data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1009 ported, it would not compile: non-const lvalue reference to type 'std::vector<uint8_t>' (aka 'vector<unsigned char>') cannot bind to a value of unrelated type '::tzc::Array<uint8_t>' (aka 'Array<unsigned char>')
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
