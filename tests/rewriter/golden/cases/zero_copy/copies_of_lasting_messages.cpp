// An object that is made as a copy has its elements before anything can allocate.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void fill(int n) { last_.data.resize(n); }
  void shared() {
    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>(last_);
    image->height++;
    first_pub_.publish(image);
  }
  void made() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image(last_));
    image->height++;
    second_pub_.publish(image);
  }
  void pointed() {
    sensor_msgs::Image image = *pointer_;
    image.height++;
    third_pub_.publish(image);
  }
  void given(const sensor_msgs::ImageConstPtr& received) {
    sensor_msgs::Image image = *boost::make_shared<sensor_msgs::Image>(*received);
    image.height++;
    fourth_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher first_pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
  sensor_msgs::Image last_;
  sensor_msgs::ImagePtr pointer_ = boost::make_shared<sensor_msgs::Image>();
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image zero_copy '1'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy '2'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy '3'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy '4'
// advertise src/node.cpp:31 sensor_msgs/Image zero_copy '1'
// advertise src/node.cpp:32 sensor_msgs/Image zero_copy '2'
// advertise src/node.cpp:33 sensor_msgs/Image zero_copy '3'
// advertise src/node.cpp:34 sensor_msgs/Image zero_copy '4'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>(last_);
// +    tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>();
// +    first_pub_.allocate(*image);
// +    *image = last_;
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image(last_));
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image());
// +    second_pub_.allocate(*image);
// +    *image = last_;
// -    sensor_msgs::Image image = *pointer_;
// +    tzc::sensor_msgs::Image image;
// +    third_pub_.allocate(image);
// +    image = *pointer_;
// -    sensor_msgs::Image image = *boost::make_shared<sensor_msgs::Image>(*received);
// +    tzc::sensor_msgs::Image image;
// +    fourth_pub_.allocate(image);
// +    image = *boost::make_shared<sensor_msgs::Image>(*received);
// -  ros::Publisher first_pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
// -  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
// +  tzc::Publisher first_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "1", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "2", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "3", 1);
// +  tzc::Publisher fourth_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "4", 1);
