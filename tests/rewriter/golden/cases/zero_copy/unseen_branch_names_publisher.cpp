// The publisher is handed on in code that is not compiled.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void keep(ros::Publisher& pub);

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
#if defined(KEEP)
    keep(pub_);
#endif
  }
  void send() {
    sensor_msgs::Image image;
    image.data.resize(10);
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
