// One of several publishers sends the message, and each may be null: it is allocated from one that is there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(bool raw) {
    if (raw)
      raw_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("raw", 10)));
    else
      rectified_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("rectified", 10)));
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (raw_) {
      image.step = 1;
      raw_->publish(image);
    } else if (rectified_) {
      rectified_->publish(image);
    }
  }

 private:
  ros::NodeHandle nh_;
  boost::shared_ptr<ros::Publisher> raw_, rectified_;
};

class Debugged {
 public:
  explicit Debugged(bool debug) {
    image_ = nh_.advertise<sensor_msgs::Image>("image", 10);
    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 10)));
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (debug_) debug_->publish(image);
    image_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher image_;
  boost::shared_ptr<ros::Publisher> debug_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'raw'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'rectified'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'raw'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'rectified'
// advertise src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:33 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      raw_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("raw", 10)));
// +      raw_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "raw", 10)));
// -      rectified_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("rectified", 10)));
// +      rectified_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "rectified", 10)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (raw_) raw_->allocate(image); else if (rectified_) rectified_->allocate(image);
// -  boost::shared_ptr<ros::Publisher> raw_, rectified_;
// +  boost::shared_ptr<tzc::Publisher> raw_, rectified_;
// -    image_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// -    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 10)));
// +    image_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// +    if (debug) debug_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "debug", 10)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    image_.allocate(image);
// -  ros::Publisher image_;
// -  boost::shared_ptr<ros::Publisher> debug_;
// +  tzc::Publisher image_;
// +  boost::shared_ptr<tzc::Publisher> debug_;
