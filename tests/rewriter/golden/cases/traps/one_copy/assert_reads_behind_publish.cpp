// A debug build reads the array behind the publish, where assert() does.
//RUN: flags=-DNDEBUG
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cassert>

class Node {
 public:
  void tick(int n) {
    image_.data.assign(n, 7);
    const uint8_t* first = image_.data.data();
    pub_.publish(image_);
    ++image_.data[0];
    assert(*first == 8);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
