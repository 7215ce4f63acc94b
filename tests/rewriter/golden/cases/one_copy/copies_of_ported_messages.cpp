// Copies that no statement can allocate: each costs a copy where it is published itself, and what it is made from costs none.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void in_a_head(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    if (sensor_msgs::Image last = image; count > 5) {
      last.data[0] = 2;
      copy_pub_.publish(last);
    }
  }
  void several(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    sensor_msgs::Image left = image, right = image;
    pub_.publish(image);
    copy_pub_.publish(left);
    copy_pub_.publish(right);
  }
  void constant(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    const sensor_msgs::Image before = image;
    pub_.publish(image);
    copy_pub_.publish(before);
  }
  void unnamed(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    copy_pub_.publish(boost::make_shared<sensor_msgs::Image>(image));
  }
  void replaced(int count) {
    first_.data.assign(count, 1);
    pub_.publish(first_);
    if (!current_) {
      current_.reset(new sensor_msgs::Image);
      *current_ = first_;
    }
    current_pub_.publish(current_);
    current_ = boost::make_shared<sensor_msgs::Image>(*current_);
    current_->data[0] = 3;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
  ros::Publisher current_pub_ = nh_.advertise<sensor_msgs::Image>("current", 1);
  sensor_msgs::Image first_;
  sensor_msgs::ImagePtr current_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 11), whose elements lie outside shared memory until it is published
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 19), whose elements lie outside shared memory until it is published
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 19), whose elements lie outside shared memory until it is published
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 27), whose elements lie outside shared memory until it is published
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'copy'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:44 sensor_msgs/Image one_copy 'current' TZC1022 it is a copy (made in line 45), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:51 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:52 sensor_msgs/Image zero_copy 'copy'
// advertise src/node.cpp:53 sensor_msgs/Image one_copy 'current'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    if (sensor_msgs::Image last = image; count > 5) {
// +    if (tzc::sensor_msgs::Image last = image; count > 5) {
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image left = image, right = image;
// +    tzc::sensor_msgs::Image left = image, right = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    const sensor_msgs::Image before = image;
// +    const tzc::sensor_msgs::Image before = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    copy_pub_.publish(boost::make_shared<sensor_msgs::Image>(image));
// +    copy_pub_.publish(boost::make_shared<tzc::sensor_msgs::Image>(image));
// -      current_.reset(new sensor_msgs::Image);
// +      current_.reset(new tzc::sensor_msgs::Image);
// +      pub_.allocate(*current_);
// -    current_ = boost::make_shared<sensor_msgs::Image>(*current_);
// +    current_ = boost::make_shared<tzc::sensor_msgs::Image>(*current_);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
// -  ros::Publisher current_pub_ = nh_.advertise<sensor_msgs::Image>("current", 1);
// -  sensor_msgs::Image first_;
// -  sensor_msgs::ImagePtr current_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher copy_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "copy", 1);
// +  tzc::Publisher current_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "current", 1);
// +  tzc::sensor_msgs::Image first_;
// +  tzc::sensor_msgs::ImagePtr current_;
