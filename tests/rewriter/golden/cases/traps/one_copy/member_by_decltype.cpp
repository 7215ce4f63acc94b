// The type is that of an expression in which nothing can be ported.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

class Node {
 public:
  void tick(int n) {
    image_.data.assign(n, 7);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  std::decay_t<decltype(*sensor_msgs::ImagePtr())> image_;
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1005 its type hides behind the name 'decltype(*sensor_msgs::ImagePtr())'
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
