// An earlier run attached the topic of a publisher that can be ported now.
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
  }
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(640 * 480);
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
