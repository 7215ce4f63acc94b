// Sizes that macros write are not the same because neither has a text of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstring>

#define WHOLE (100)
#define HALF (50)
#define WIDTH (2 * 50)
#define HEIGHT (5 + 5)

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void by_memcpy(const uint8_t* pixels) {
    a_.data.resize(WHOLE);
    memcpy(&a_.data[0], pixels, HALF);
    pub_.publish(a_);
  }
  void by_loop() {
    b_.data.resize(WHOLE);
    for (int i = 0; i < HALF; ++i) b_.data[i] = 1;
    pub_.publish(b_);
  }
  void by_sum() {
    c_.data.resize(WIDTH);
    for (int i = 0; i < HEIGHT; ++i) c_.data[i] = 1;
    pub_.publish(c_);
  }
  void by_cast(const uint8_t* pixels) {
    d_.data.resize(std::size_t(WHOLE));
    memcpy(&d_.data[0], pixels, HALF);
    pub_.publish(d_);
  }
  void in_parentheses() {
    e_.data.resize((WHOLE));
    for (int i = 0; i < HALF; ++i) e_.data[i] = 1;
    pub_.publish(e_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image a_, b_, c_, d_, e_;
};
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1022 line 17 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1022 line 22 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'image' TZC1022 line 27 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:33 sensor_msgs/Image one_copy 'image' TZC1022 line 32 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:38 sensor_msgs/Image one_copy 'image' TZC1022 line 37 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image a_, b_, c_, d_, e_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image a_, b_, c_, d_, e_;
