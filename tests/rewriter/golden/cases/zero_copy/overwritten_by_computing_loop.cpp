// Members that keep their elements from message to message, where a loop computes each of them in numbers of its own.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <cmath>
#include <vector>

struct Echo {
  int ticks;
  struct {
    float power[2];
  } received;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void of_structs() {
    scan_.ranges.resize(echoes_.size());
    for (std::size_t i = 0; i < echoes_.size(); ++i) scan_.ranges[i] = echoes_[i].ticks;
    pub_.publish(scan_);
  }
  void of_arrays_in_structs(const std::vector<Echo>& echoes) {
    scan_.ranges.resize(echoes.size());
    for (std::size_t i = 0; i < echoes.size(); ++i)
      scan_.ranges[i] = echoes[i].received.power[0] + echoes_[i].received.power[i % 2];
    pub_.publish(scan_);
  }
  void computed(const std::vector<Echo>& echoes) {
    scan_.ranges.resize(echoes.size());
    scan_.intensities.resize(echoes.size());
    for (std::size_t i = 0; i < echoes.size(); ++i) {
      float range = echoes[i].ticks * scale_, power;
      if (range > limit_) {
        range = limit_;
      }
      power = echoes[i].received.power[0];
      power *= 2;
      scan_.ranges[i] = range;
      if (power < 1)
        scan_.intensities[i] = 0;
      else
        scan_.intensities[i] = std::sqrt(power);
    }
    pub_.publish(scan_);
  }
  void one_of_two(unsigned n) {
    scan_.ranges.resize(n);
    for (float& range : scan_.ranges) {
      if (const_) {
        range = 1;
      } else {
        const float half = scale_ / 2;
        range = half;
      }
    }
    pub_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
  std::vector<Echo> echoes_;
  bool const_ = false;
  float scale_ = 1, limit_ = 3;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:21 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:27 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:45 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:57 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -    scan_.ranges.resize(echoes_.size());
// +    scan_.ranges.resize(echoes_.size(), tzc::uninitialized);
// -    scan_.ranges.resize(echoes.size());
// +    scan_.ranges.resize(echoes.size(), tzc::uninitialized);
// -    scan_.ranges.resize(echoes.size());
// -    scan_.intensities.resize(echoes.size());
// +    scan_.ranges.resize(echoes.size(), tzc::uninitialized);
// +    scan_.intensities.resize(echoes.size(), tzc::uninitialized);
// -    scan_.ranges.resize(n);
// +    scan_.ranges.resize(n, tzc::uninitialized);
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
