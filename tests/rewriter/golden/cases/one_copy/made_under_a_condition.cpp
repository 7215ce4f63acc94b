// The pointer may be null behind the statement that makes the message, or another variable has it already.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void choice(int k) {
    sensor_msgs::ImagePtr image = k % 2 ? boost::make_shared<sensor_msgs::Image>() : sensor_msgs::ImagePtr();
    if (!image) return;
    image->data.assign(100, k);
    pub_.publish(image);
  }
  void operand(int k) {
    k % 2 && (second_ = boost::make_shared<sensor_msgs::Image>());
    if (second_) second_pub_.publish(second_);
  }
  void reset(int k) {
    third_.reset(k % 2 ? new sensor_msgs::Image : nullptr);
    if (third_) third_pub_.publish(*third_);
  }
  void raw(int k) {
    sensor_msgs::Image* image = k % 2 ? new sensor_msgs::Image : nullptr;
    if (!image) return;
    image->data.assign(100, k);
    fourth_pub_.publish(*image);
    delete image;
  }
  void moved() {
    auto first = boost::make_shared<sensor_msgs::Image>(), image = std::move(first);
    image->data.assign(100, 1);
    fifth_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
  ros::Publisher fifth_pub_ = nh_.advertise<sensor_msgs::Image>("5", 1);
  sensor_msgs::ImagePtr second_;
  std::unique_ptr<sensor_msgs::Image> third_;
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image one_copy '1' TZC1019 it is made under a condition only
// publish src/node.cpp:15 sensor_msgs/Image one_copy '2' TZC1019 it is made under a condition only
// publish src/node.cpp:19 sensor_msgs/Image one_copy '3' TZC1019 it is made under a condition only
// publish src/node.cpp:25 sensor_msgs/Image one_copy '4' TZC1019 it is made under a condition only
// publish src/node.cpp:31 sensor_msgs/Image one_copy '5' TZC1019 a variable that is declared behind it in the same statement is made from it
// advertise src/node.cpp:36 sensor_msgs/Image one_copy '1'
// advertise src/node.cpp:37 sensor_msgs/Image one_copy '2'
// advertise src/node.cpp:38 sensor_msgs/Image one_copy '3'
// advertise src/node.cpp:39 sensor_msgs/Image one_copy '4'
// advertise src/node.cpp:40 sensor_msgs/Image one_copy '5'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
// -  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
// -  ros::Publisher fifth_pub_ = nh_.advertise<sensor_msgs::Image>("5", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "1", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "2", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "3", 1);
// +  tzc::Publisher fourth_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "4", 1);
// +  tzc::Publisher fifth_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "5", 1);
