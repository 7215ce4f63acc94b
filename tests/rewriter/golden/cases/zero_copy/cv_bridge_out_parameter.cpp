// image.toImageMsg(message).
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(const cv_bridge::CvImage& image) {
    sensor_msgs::Image message;
    image.toImageMsg(message);
    pub_.publish(message);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image message;
// -    image.toImageMsg(message);
// +    tzc::sensor_msgs::Image message;
// +    pub_.allocate(message);
// +    tzc::cv_bridge::to_image_msg(image, message);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
