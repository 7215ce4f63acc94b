// A function of the package in a library's namespace, and one that takes a function: they may write to what was kept.
#include <angles/angles.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

void library(uint8_t* pixels);
uint8_t* pixels_of_library();

namespace angles {
double normalize_angle(float angle) {
  pixels_of_library()[0] = 7;
  return angle;
}
}  // namespace angles

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    library(&image.data[0]);
    pub_.publish(image);
    angle_ = angles::normalize_angle(3.0f);
  }
  void compare() {
    sensor_msgs::Image other;
    other.data.resize(100);
    library(&other.data[0]);
    pub_.publish(other);
    angle_ = std::max(1.0, angle_, [](double a, double b) { return (pixels_of_library()[0] = 7) + a < b; });
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  double angle_ = 0;
};
//--- expected
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
