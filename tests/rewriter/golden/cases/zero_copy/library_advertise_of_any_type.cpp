// A base class of another package advertises a type that it knows alone: the publisher stays what it is.
#include <other/library.h>

class Child : public other::Nodelet {
 public:
  explicit Child(ros::NodeHandle& nh) { images_ = advertise_any(nh, "image"); }
  void poll() {
    sensor_msgs::Image image;
    image.data.resize(10);
    images_.publish(image);
  }

 private:
  ros::Publisher images_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    images_.publish(image);
// +    tzc::publish(images_, image);
