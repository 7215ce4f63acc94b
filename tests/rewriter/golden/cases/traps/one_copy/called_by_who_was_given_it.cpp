// What a member holds, or a future runs when it is asked, writes to what was published, which is let go afterwards.
#include <functional>
#include <future>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::Image>("lasting", 1);
    other_ = nh.advertise<sensor_msgs::Image>("deferred", 1);
    alone_ = nh.advertise<sensor_msgs::Image>("alone", 1);
    change_ = [this] { image_.data[0] = 1; };
  }
  void lasting() {
    image_.data.assign(100, 1);
    pub_.publish(image_);
    change_();
    image_.data.clear();
  }
  void deferred() {
    later_.data.assign(100, 1);
    auto change = std::async(std::launch::deferred, [this] { later_.data[0] = 1; });
    other_.publish(later_);
    change.get();
    later_.data.clear();
  }
  void alone() {
    quiet_.data.assign(100, 1);
    alone_.publish(quiet_);
    change_();
    quiet_.data.clear();
  }

 private:
  ros::Publisher pub_, other_, alone_;
  sensor_msgs::Image image_, later_, quiet_;
  std::function<void()> change_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'lasting'
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'deferred'
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'alone'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'lasting' TZC1022 line 14 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'deferred' TZC1022 line 24 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'alone'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh.advertise<sensor_msgs::Image>("lasting", 1);
// -    other_ = nh.advertise<sensor_msgs::Image>("deferred", 1);
// -    alone_ = nh.advertise<sensor_msgs::Image>("alone", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "lasting", 1);
// +    other_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "deferred", 1);
// +    alone_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "alone", 1);
// -  ros::Publisher pub_, other_, alone_;
// -  sensor_msgs::Image image_, later_, quiet_;
// +  tzc::Publisher pub_, other_, alone_;
// +  tzc::sensor_msgs::Image image_, later_, quiet_;
