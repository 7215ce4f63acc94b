// An override that the call cannot reach is no event.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <exception>
#include <ostream>

struct Failure : std::exception {
  const char* what() const noexcept override { return "failure"; }
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(std::ostream& out) {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    out << 1;
    *first = 1;
    pub_.publish(image_);
    image_.data.clear();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
