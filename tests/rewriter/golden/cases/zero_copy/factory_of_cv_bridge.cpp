// Functions that return what toImageMsg() makes get the publisher from their callers.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

sensor_msgs::ImagePtr converted(const cv::Mat& mat) {
  return cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
}

class Node {
 public:
  Node() {
    left_ = nh_.advertise<sensor_msgs::Image>("left", 10);
    right_ = nh_.advertise<sensor_msgs::Image>("right", 10);
  }
  void publish(const cv::Mat& left, const cv::Mat& right) {
    left_.publish(converted(left));
    right_.publish(stamped(right));
  }

 private:
  sensor_msgs::ImagePtr stamped(const cv::Mat& mat) {
    sensor_msgs::ImagePtr message = converted(mat);
    message->header.stamp = ros::Time::now();
    return message;
  }

  ros::NodeHandle nh_;
  ros::Publisher left_, right_;
};

class Camera {
 public:
  void open() {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = nh_.advertise<sensor_msgs::Image>("camera", 10);
  }
  void publish() { pub_.publish(*message()); }

 private:
  const sensor_msgs::ImagePtr message() const { return image_.toImageMsg(); }

  ros::NodeHandle nh_;
  std::mutex mutex_;
  ros::Publisher pub_;
  cv_bridge::CvImage image_;
};
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'right'
// advertise src/node.cpp:38 sensor_msgs/Image zero_copy 'camera'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'camera'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr converted(const cv::Mat& mat) {
// -  return cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
// +tzc::sensor_msgs::ImagePtr converted(const tzc::Publisher& publisher, const cv::Mat& mat) {
// +  return tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), publisher);
// -    left_ = nh_.advertise<sensor_msgs::Image>("left", 10);
// -    right_ = nh_.advertise<sensor_msgs::Image>("right", 10);
// +    left_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 10);
// +    right_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 10);
// -    left_.publish(converted(left));
// +    left_.publish(converted(left_, left));
// -  sensor_msgs::ImagePtr stamped(const cv::Mat& mat) {
// -    sensor_msgs::ImagePtr message = converted(mat);
// +  tzc::sensor_msgs::ImagePtr stamped(const cv::Mat& mat) {
// +    tzc::sensor_msgs::ImagePtr message = converted(left_, mat);
// -  ros::Publisher left_, right_;
// +  tzc::Publisher left_, right_;
// -    pub_ = nh_.advertise<sensor_msgs::Image>("camera", 10);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "camera", 10);
// -  void publish() { pub_.publish(*message()); }
// +  void publish() { pub_.publish(*message(pub_)); }
// -  const sensor_msgs::ImagePtr message() const { return image_.toImageMsg(); }
// +  const tzc::sensor_msgs::ImagePtr message(const tzc::Publisher& publisher) const { return tzc::cv_bridge::to_image_msg(image_, publisher); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
