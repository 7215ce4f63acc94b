// A base class of another package advertises, and a macro calls it: the publisher stays what it is.
#include <other/library.h>
#define ADVERTISE(nh, type, name) advertise<type>(nh, name, 1)

class Child : public other::Nodelet {
 public:
  explicit Child(ros::NodeHandle& nh) { images_ = ADVERTISE(nh, sensor_msgs::Image, "image"); }
  void poll() {
    sensor_msgs::Image image;
    image.data.resize(10);
    images_.publish(image);
  }

 private:
  ros::Publisher images_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    images_.publish(image);
// +    tzc::publish(images_, image);
