// Written once more for allocate, these expressions would count twice or mean another message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Slot {
  sensor_msgs::Image image;
};
struct Frame {
  sensor_msgs::Image picture;
  Frame* next;
};

class Node {
 public:
  void made(int k) {
    images_[count_++ % 3] = boost::make_shared<sensor_msgs::Image>();
    pub_.publish(images_[(count_ + 2) % 3]);
  }
  void then_changed() {
    others_[at_] = boost::make_shared<sensor_msgs::Image>(), at_ = 1 - at_;
    second_pub_.publish(others_[1 - at_]);
  }
  void published() { third_pub_.publish(slots_[count_++ % 3].image); }
  void assigned() { fourth_pub_.publish((current_ = current_->next)->picture); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
  sensor_msgs::ImagePtr images_[3], others_[2];
  int count_ = 0, at_ = 0;
  Slot slots_[3];
  Frame* current_ = nullptr;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy '1' TZC1019 the expression that names it means something else, or nothing, where allocate would stand
// publish src/node.cpp:21 sensor_msgs/Image one_copy '2' TZC1019 it is made under a condition only
// publish src/node.cpp:23 sensor_msgs/Image zero_copy '3'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy '4'
// advertise src/node.cpp:28 sensor_msgs/Image one_copy '1'
// advertise src/node.cpp:29 sensor_msgs/Image one_copy '2'
// advertise src/node.cpp:30 sensor_msgs/Image zero_copy '3'
// advertise src/node.cpp:31 sensor_msgs/Image zero_copy '4'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  sensor_msgs::Image picture;
// +  tzc::sensor_msgs::Image picture;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
// -  ros::Publisher fourth_pub_ = nh_.advertise<sensor_msgs::Image>("4", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "1", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "2", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "3", 1);
// +  tzc::Publisher fourth_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "4", 1);
