// What stands between always comes back, so the index is used in any case.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Output {
  ros::Publisher pub;
};
unsigned half(unsigned n) {
  return n / 2;
}

class Node {
 public:
  Node() {
    outputs_.resize(1);
    outputs_[0].pub = nh_.advertise<sensor_msgs::Image>("image", 10);
  }
  void publish(unsigned i, const std::string& frame) {
    sensor_msgs::Image image;
    image.header.stamp = ros::Time::now();
    image.header.frame_id = frame + "_link";
    image.data.assign(half(100), 0);
    std::fill(image.data.begin(), image.data.end(), 1);
    outputs_[i].pub.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::vector<Output> outputs_;
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub;
// +  tzc::Publisher pub;
// -    outputs_[0].pub = nh_.advertise<sensor_msgs::Image>("image", 10);
// +    outputs_[0].pub = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    outputs_[i].pub.allocate(image);
