// The view was used before the function writes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void publish() {
    const sensor_msgs::Image& view = image_;
    const uint8_t* first = view.data.data();
    last_ = *first;
    fill();
    pub_.publish(image_);
  }

 private:
  void fill() { image_.data.assign(4, 7); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  uint8_t last_ = 0;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -    const sensor_msgs::Image& view = image_;
// +    const tzc::sensor_msgs::Image& view = image_;
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
