// A class template of the package that is made with the type asks for it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>
#include <typeinfo>

template <class M>
struct Kind {
  int code() const { return std::is_same<M, sensor_msgs::Image>::value ? 1 : 0; }
  std::string name() const { return typeid(M).name(); }
};

template <class M>
void stamp(M& message) {
  Kind<M> kind;
  message.height = kind.code();
  message.header.frame_id = Kind<M>().name();
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.resize(n);
  stamp(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'image' TZC1001 'stamp' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
