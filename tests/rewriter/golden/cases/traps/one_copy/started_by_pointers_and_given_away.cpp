// What an object starts with goes to others by another name, under which each message may be a new one.
#include <deque>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Builder {
 public:
  Builder() : image_(new sensor_msgs::Image) {}
  sensor_msgs::ImagePtr take(int n) {
    image_->data.resize(n);
    return std::move(image_);
  }

 private:
  ros::NodeHandle nh_;
  sensor_msgs::ImagePtr image_;
};

struct Frame {
  ros::NodeHandle nh;
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
};

class Node {
 public:
  void built(int n) {
    Builder builder;
    built_pub_.publish(builder.take(n));
  }
  void queued(int n) {
    Frame frame;
    frame.image->data.resize(n);
    queue_.push_back(frame.image);
    queued_pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher built_pub_ = nh_.advertise<sensor_msgs::Image>("built", 1);
  ros::Publisher queued_pub_ = nh_.advertise<sensor_msgs::Image>("queued", 1);
  std::deque<sensor_msgs::ImagePtr> queue_;
};
//--- expected
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'built' TZC1019 line 9 makes it with its object, where no statement can stand, and the object gives it away
// publish src/node.cpp:35 sensor_msgs/Image one_copy 'queued' TZC1019 line 22 makes it with its object, where no statement can stand, and the object gives it away
// advertise src/node.cpp:41 sensor_msgs/Image one_copy 'built'
// advertise src/node.cpp:42 sensor_msgs/Image one_copy 'queued'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher built_pub_ = nh_.advertise<sensor_msgs::Image>("built", 1);
// -  ros::Publisher queued_pub_ = nh_.advertise<sensor_msgs::Image>("queued", 1);
// +  tzc::Publisher built_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "built", 1);
// +  tzc::Publisher queued_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "queued", 1);
