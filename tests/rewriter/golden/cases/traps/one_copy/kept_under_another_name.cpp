// What is overwritten is named as what was resized, and may be another array, or read what it writes by a struct's field.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

struct Frame {
  sensor_msgs::Image image;
};

struct Reading {
  float value;
};

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
  }
  void by_chance(const uint8_t* pixels) {
    frames_[std::rand() % 2].image.data.resize(100);
    memcpy(&frames_[std::rand() % 2].image.data[0], pixels, 100);
    pub_.publish(frames_[0].image);
  }
  void by_field(int n, const Reading* reading) {
    scan_.ranges.resize(n);
    std::fill(scan_.ranges.begin(), scan_.ranges.end(), reading->value);
    scans_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_, scans_;
  Frame frames_[2];
  sensor_msgs::LaserScan scan_;
};
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:22 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'image' TZC1022 line 26 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:32 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 31 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// -    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// +    scans_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10);
// -  ros::Publisher pub_, scans_;
// +  tzc::Publisher pub_, scans_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::sensor_msgs::LaserScan scan_;
