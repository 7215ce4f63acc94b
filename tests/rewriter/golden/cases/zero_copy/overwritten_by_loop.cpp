// Members that keep their elements from message to message, where a loop writes all of them: no copy, and no zero-fill.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <vector>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void from_vector(const std::vector<float>& values) {
    scan_.ranges.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) scan_.ranges[i] = values[i];
    pub_.publish(scan_);
  }
  void from_buffer(unsigned n) {
    const unsigned count = n;
    scan_.ranges.resize(count);
    least_ = 0;
    for (unsigned i = 0; i != count; i++) {
      scan_.ranges[i] = static_cast<float>(buffer_[i % 16]) * scale_ + least_;
    }
    pub_.publish(scan_);
  }
  void to_its_size(int rows, int columns) {
    scan_.ranges.resize(rows * columns);
    for (int i = 0; i < scan_.ranges.size(); ++i) scan_.ranges[i] = i < rows ? 0.5f : -buffer_[0];
    pub_.publish(scan_);
  }
  void area(int rows, int columns) {
    scan_.ranges.resize(rows * columns);
    for (int i = 0; i < rows * columns; ++i) scan_.ranges[i] = i;
    pub_.publish(scan_);
  }
  void range_loop(int n) {
    scan_.ranges.resize(n);
    for (float& range : scan_.ranges) range = std::max(0.5f, scale_);
    pub_.publish(scan_);
  }
  void both(const std::vector<double>& distances) {
    scan_.ranges.resize(distances.size());
    scan_.intensities.resize(distances.size());
    for (std::size_t i = 0; i < distances.size(); ++i) {
      scan_.ranges[i] = static_cast<float>(distances[i]);
      scan_.intensities[i] = std::abs(buffer_[i % 16]);
    }
    pub_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan scan_;
  float buffer_[16] = {}, scale_ = 1, least_ = 0;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:14 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:23 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:28 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:33 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:38 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:47 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -    scan_.ranges.resize(values.size());
// +    scan_.ranges.resize(values.size(), tzc::uninitialized);
// -    scan_.ranges.resize(count);
// +    scan_.ranges.resize(count, tzc::uninitialized);
// -    scan_.ranges.resize(rows * columns);
// +    scan_.ranges.resize(rows * columns, tzc::uninitialized);
// -    scan_.ranges.resize(rows * columns);
// +    scan_.ranges.resize(rows * columns, tzc::uninitialized);
// -    scan_.ranges.resize(n);
// +    scan_.ranges.resize(n, tzc::uninitialized);
// -    scan_.ranges.resize(distances.size());
// -    scan_.intensities.resize(distances.size());
// +    scan_.ranges.resize(distances.size(), tzc::uninitialized);
// +    scan_.intensities.resize(distances.size(), tzc::uninitialized);
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan scan_;
