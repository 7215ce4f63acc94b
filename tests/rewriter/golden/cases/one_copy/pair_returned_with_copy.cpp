// A function returns a copy of a message in a pair, which a structured binding takes apart.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <utility>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick(unsigned n) {
    image_.data.resize(n);
    auto [image, number] = both();
    pub_.publish(image);
  }

 private:
  std::pair<sensor_msgs::Image, int> both() { return {image_, 1}; }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Node node(nh);
  for (unsigned i = 0; ros::ok(); ++i) node.tick(i);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 its elements come from a message that is never published itself (returned from 'both' in line 16), and lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -  std::pair<sensor_msgs::Image, int> both() { return {image_, 1}; }
// +  std::pair<tzc::sensor_msgs::Image, int> both() { return {image_, 1}; }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
