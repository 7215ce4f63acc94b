// A member gives its elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    buffer_.resize(100);
    image_.data.swap(buffer_);
    first_[0] = 1;
    pub_.publish(image_);
  }
  void start() { first_ = buffer_.data(); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::vector<uint8_t> buffer_;
  uint8_t* first_ = nullptr;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may exist: 'buffer_' gives the array its elements
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
