// Statements that stand alone in place of a block, and behind labels.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void once(int n) {
    if (!image_) image_.reset(new sensor_msgs::Image);
    image_->data.assign(n, 7);
    pub_.publish(image_);
    image_.reset();
  }
  void otherwise(int n, bool again) {
    if (again)
      second_->data.clear();
    else
      second_ = boost::make_shared<sensor_msgs::Image>();
    second_->data.assign(n, 7);
    second_pub_.publish(second_);
    second_.reset();
  }
  void chosen(int kind, int n) {
    sensor_msgs::ImagePtr image;
    switch (kind) {
      case 0:
      case 1:
        image = boost::make_shared<sensor_msgs::Image>();
        break;
      default:
        image.reset(new sensor_msgs::Image);
    }
    image->data.assign(n, 7);
    third_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
  sensor_msgs::ImagePtr image_, second_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy '1'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy '2'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy '3'
// advertise src/node.cpp:38 sensor_msgs/Image zero_copy '1'
// advertise src/node.cpp:39 sensor_msgs/Image zero_copy '2'
// advertise src/node.cpp:40 sensor_msgs/Image zero_copy '3'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    if (!image_) image_.reset(new sensor_msgs::Image);
// +    if (!image_) { image_.reset(new tzc::sensor_msgs::Image); pub_.allocate(*image_); }
// -      second_ = boost::make_shared<sensor_msgs::Image>();
// +      { second_ = boost::make_shared<tzc::sensor_msgs::Image>(); second_pub_.allocate(*second_); }
// -    sensor_msgs::ImagePtr image;
// +    tzc::sensor_msgs::ImagePtr image;
// -        image = boost::make_shared<sensor_msgs::Image>();
// +        image = boost::make_shared<tzc::sensor_msgs::Image>();
// +        third_pub_.allocate(*image);
// -        image.reset(new sensor_msgs::Image);
// +        image.reset(new tzc::sensor_msgs::Image);
// +        third_pub_.allocate(*image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
// -  sensor_msgs::ImagePtr image_, second_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "1", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "2", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "3", 1);
// +  tzc::sensor_msgs::ImagePtr image_, second_;
