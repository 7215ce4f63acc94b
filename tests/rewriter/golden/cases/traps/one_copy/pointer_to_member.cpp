// A pointer to the member leads into the data while they are published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Stereo {
 public:
  void tick(int n) {
    left_.data.assign(n, 7);
    uint8_t* first = begin_of(&Stereo::left_);
    left_pub_.publish(left_);
    left_.data[1] = 1;
    *first = 255;
    ROS_INFO("%d", left_.data[0]);
    auto same = &Stereo::left_;
    ROS_INFO("%d", (this->*same).data[0]);
  }

 private:
  template <class Member>
  uint8_t* begin_of(Member member) {
    auto& image = this->*member;
    return image.data.data();
  }

  ros::NodeHandle nh_;
  ros::Publisher left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
  sensor_msgs::Image left_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'left' TZC1001 a pointer to the member leads to it
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'left'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher left_pub_ = nh_.advertise<sensor_msgs::Image>("left", 1);
// +  tzc::Publisher left_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "left", 1);
