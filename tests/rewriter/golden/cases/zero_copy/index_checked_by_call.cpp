// What stands between may throw, or end the program, when the index or pointer is not valid.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstdlib>
#include <stdexcept>

struct Output {
  ros::Publisher pub;
  std::string frame;
};
void check(unsigned i, unsigned n) {
  if (i >= n) throw std::out_of_range("no such output");
}

class Node {
 public:
  Node() {
    outputs_.resize(1);
    outputs_[0].pub = nh_.advertise<sensor_msgs::Image>("image", 10);
    named_["left"].pub = outputs_[0].pub;
  }
  void by_at(unsigned i) {
    sensor_msgs::Image image;
    image.header.frame_id = frames_.at(i);
    image.data.resize(100);
    outputs_[i].pub.publish(image);
  }
  void by_function(unsigned i) {
    sensor_msgs::Image image;
    image.data.resize(100);
    check(i, count_);
    outputs_[i].pub.publish(image);
  }
  void by_map(const std::string& name) {
    const auto it = named_.find(name);
    sensor_msgs::Image image;
    image.header.frame_id = named_.at(name).frame;
    image.data.resize(100);
    it->second.pub.publish(image);
  }
  void by_exit(Output* output) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (!output) std::exit(1);
    output->pub.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  unsigned count_ = 1;
  std::vector<std::string> frames_;
  std::vector<Output> outputs_;
  std::map<std::string, Output> named_;
};
//--- expected
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:27 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:46 sensor_msgs/Image zero_copy 'image'
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
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
