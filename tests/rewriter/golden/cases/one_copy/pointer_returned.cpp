// A pointer into the data is returned.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  uint8_t* pixels() { return image_.data.data(); }
  void publish() {
    image_.data.resize(10);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is returned
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
