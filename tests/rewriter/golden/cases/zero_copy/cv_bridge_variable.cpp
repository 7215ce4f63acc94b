// ImagePtr m = image.toImageMsg(); m->header = ...; publish(m).
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(const cv::Mat& mat) {
    sensor_msgs::ImagePtr message = cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
    message->header.frame_id = "camera";
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
// -    sensor_msgs::ImagePtr message = cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
// +    tzc::sensor_msgs::ImagePtr message = tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), pub_);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
