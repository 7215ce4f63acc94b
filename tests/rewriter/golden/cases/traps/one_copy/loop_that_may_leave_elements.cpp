// Loops behind a resize that do not give each element a value of their own making: the last message's elements may stay.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

struct Echo {
  float range;
  float* best;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void only_some() {
    some_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      const float range = echoes_[i].range;
      if (range > 0) some_.ranges[i] = range;
    }
    pub_.publish(some_);
  }
  void some_of_two() {
    two_.ranges.resize(echoes_.size());
    two_.intensities.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i)
      if (echoes_[i].range > 0)
        two_.ranges[i] = echoes_[i].range;
      else
        two_.intensities[i] = 0;
    pub_.publish(two_);
  }
  void skipped() {
    skipped_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      if (echoes_[i].range < 0) continue;
      skipped_.ranges[i] = echoes_[i].range;
    }
    pub_.publish(skipped_);
  }
  void larger_ones() {
    larger_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      float range = echoes_[i].range;
      if (larger_.ranges[i] > range) range = larger_.ranges[i];
      larger_.ranges[i] = range;
    }
    pub_.publish(larger_);
  }
  void behind_pointers() {
    led_to_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) led_to_.ranges[i] = *echoes_[i].best;
    pub_.publish(led_to_);
  }
  void shorter(int n) {
    shorter_.ranges.resize(n);
    for (int i = 0; i < n; ++i) {
      shorter_.ranges[i] = 1;
      if (echoes_[i].range < 0) n = i;
    }
    pub_.publish(shorter_);
  }
  void of_another(int k) {
    rows_[k].ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      const int k = 1;
      rows_[k].ranges[i] = echoes_[i].range;
    }
    pub_.publish(rows_[k]);
  }
  void counted_on() {
    counted_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      static float last = 0;
      last = last + echoes_[i].range;
      counted_.ranges[i] = last;
      ++i;
    }
    pub_.publish(counted_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan some_, two_, skipped_, larger_, led_to_, shorter_, counted_, rows_[2];
  std::vector<Echo> echoes_;
};
//--- expected
// advertise src/node.cpp:14 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 19 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:31 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 28 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:39 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 37 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:48 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 45 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:53 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 52 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:61 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 58 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:69 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 67 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:79 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 76 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan some_, two_, skipped_, larger_, led_to_, shorter_, counted_, rows_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan some_, two_, skipped_, larger_, led_to_, shorter_, counted_, rows_[2];
