// What toImageMsg() makes is returned to one caller that knows the publisher and to one that does not.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::ImagePtr converted(const cv::Mat& mat) {
  return cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
}

sensor_msgs::ImagePtr last;

void keep(const cv::Mat& mat) { last = converted(mat); }

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish(const cv::Mat& mat) { pub_.publish(converted(mat)); }
  void publish_last() { pub_.publish(last); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr converted(const cv::Mat& mat) {
// -  return cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
// +tzc::sensor_msgs::ImagePtr converted(const cv::Mat& mat) {
// +  return tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), tzc::Publisher());
// -sensor_msgs::ImagePtr last;
// +tzc::sensor_msgs::ImagePtr last;
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
