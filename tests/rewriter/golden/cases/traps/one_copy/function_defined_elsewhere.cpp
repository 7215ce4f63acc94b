// A function without a body in C++, such as a signal of Qt that is connected by its text, keeps its parameters.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Grabber {
 public:
  void grabbed(sensor_msgs::Image& image);
  void grab() {
    sensor_msgs::Image image;
    image.data.resize(10);
    grabbed(image);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1001 'image' is a parameter of a function whose body was not seen
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
