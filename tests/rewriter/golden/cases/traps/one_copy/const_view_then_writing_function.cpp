// What was got through const access shows what a function writes afterwards.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void publish() {
    const sensor_msgs::Image& view = image_;
    const uint8_t* first = view.data.data();
    fill();
    last_ = *first;
    pub_.publish(image_);
  }

 private:
  void fill() { image_.data[0] = 7; }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  uint8_t last_ = 0;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published or written to
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
