// publish(image.toImageMsg()).
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(const cv::Mat& mat) {
    pub_.publish(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg());
    cv_bridge::CvImage image;
    pub_.publish(image.toImageMsg());
    cv_bridge::CvImagePtr pointer(new cv_bridge::CvImage);
    pub_.publish(pointer->toImageMsg());
    pub_.publish(*image.toImageMsg());
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    pub_.publish(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg());
// +    pub_.publish(tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), pub_));
// -    pub_.publish(image.toImageMsg());
// +    pub_.publish(tzc::cv_bridge::to_image_msg(image, pub_));
// -    pub_.publish(pointer->toImageMsg());
// -    pub_.publish(*image.toImageMsg());
// +    pub_.publish(tzc::cv_bridge::to_image_msg(*pointer, pub_));
// +    pub_.publish(*tzc::cv_bridge::to_image_msg(image, pub_));
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
