// A closure that does not capture the object builds the message: it cannot name the publisher, but the node.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick(unsigned n) {
    const auto make = [n]() {
      sensor_msgs::Image image;
      image.data.resize(n);
      return image;
    };
    pub_.publish(make());
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -      sensor_msgs::Image image;
// +      tzc::sensor_msgs::Image image;
// +      tzc::allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
