// The count is the size, cast to a type that may be too narrow for it: fewer bytes are copied.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstring>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void by_byte(const uint8_t* pixels, int count) {
    const int n = count;
    a_.data.resize(n);
    memcpy(&a_.data[0], pixels, static_cast<uint8_t>(n));
    pub_.publish(a_);
  }
  void by_short(int count) {
    const int n = count;
    b_.data.resize(n);
    memset(b_.data.data(), 7, (unsigned short)n);
    pub_.publish(b_);
  }
  void by_float(int count) {
    const int n = count;
    c_.data.resize(n);
    memset(c_.data.data(), 7, float(n));
    pub_.publish(c_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image a_, b_, c_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 line 13 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1022 line 19 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'image' TZC1022 line 25 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image a_, b_, c_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image a_, b_, c_;
