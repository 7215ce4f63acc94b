// The class of a container's elements keeps a pointer to what it is made of, by itself or by another class that it is made of.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

static const uint8_t* seen;

struct Direct {
  Direct(const uint8_t& x) : value(x) { seen = &x; }
  uint8_t value;
};
struct Part {
  Part(const uint8_t& x) : value(x) { seen = &x; }
  uint8_t value;
};
struct Whole {
  Whole(const Part& part) : value(part.value) {}
  uint8_t value;
};
struct Any {
  template <class T>
  Any(const T& x) : value(x) { seen = &x; }
  uint8_t value;
};

void by_itself(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_itself", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Direct> kept;
  kept.assign(image.data.begin(), image.data.end());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
void by_a_part(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_a_part", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Whole> kept(image.data.begin(), image.data.end());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
void by_template(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_template", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Any> kept;
  kept.assign(image.data.begin(), image.data.end());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
//--- expected
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'by_itself'
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'by_itself' TZC1003 a pointer into its data is passed to 'Direct'
// advertise src/node.cpp:37 sensor_msgs/Image one_copy 'by_a_part'
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'by_a_part' TZC1003 a pointer into its data is passed to 'Part'
// advertise src/node.cpp:45 sensor_msgs/Image one_copy 'by_template'
// publish src/node.cpp:50 sensor_msgs/Image one_copy 'by_template' TZC1003 a pointer into its data is passed to 'Any'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_itself", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_itself", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_a_part", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_a_part", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_template", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_template", 10);
