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
