// Values of class types are read from elements: a union of numbers is a value, too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Header {
  uint16_t id;
  union {
    uint16_t word;
    uint8_t bytes[2];
  } size;
};

void use(Header header);

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  const Header first = *reinterpret_cast<const Header*>(&image.data[0]);
  Header second;
  second = reinterpret_cast<Header*>(image.data.data())[1];
  pub.publish(image);
  ROS_INFO("%d %d", first.id, second.size.word);
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
