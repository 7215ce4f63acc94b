// A function is given the member that it fills by its own name; what it returns is a copy of elements that nobody shares yet.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
  void tick(unsigned n) {
    pub_.publish(image_);
    size_ = n;
    pub_.publish(filled(image_));
  }

 private:
  sensor_msgs::Image filled(const sensor_msgs::Image& in) {
    image_.data.resize(size_);
    return in;
  }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
  unsigned size_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Node node(nh);
  for (unsigned i = 0; ros::ok(); ++i) node.tick(i);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'image' TZC1022 line 16 may give it more elements after this publish, which copies those that it has
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1022 it is a copy (made in line 17), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 10)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10)) {}
// -  sensor_msgs::Image filled(const sensor_msgs::Image& in) {
// +  tzc::sensor_msgs::Image filled(const tzc::sensor_msgs::Image& in) {
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
