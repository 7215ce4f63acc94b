// A template asks for the message's type where its parameters have defaults.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
struct Code {
  static constexpr int value = 0;
};
template <>
struct Code<sensor_msgs::Image> {
  static constexpr int value = 7;
};

template <class M, int code = Code<M>::value>
void stamp(M& message) {
  message.height = code;
}
template <class M, class Policy = Code<M>>
void stamp_by_policy(M& message) {
  message.height = Policy::value;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  stamp(image);
  pub.publish(image);
  sensor_msgs::Image other;
  other.data.resize(100);
  stamp_by_policy(other);
  pub.publish(other);
}
//--- expected
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'image' TZC1001 'stamp' asks for its type
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'image' TZC1001 'stamp_by_policy' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
