// What is asked for is the type of an element, a number or the program's own vector; and a name that another one's type declares is followed.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

class Node {
 public:
  void elements() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    decltype(*it) first = *it;
    decltype(it - it) distance = 0;
    scan.angle_min = sizeof(*it) + sizeof(first) + distance;
    pub_.publish(scan);
  }
  void followed() {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    auto it = scan.ranges.begin();
    decltype(it) next = it;
    *++next = 1;
    pub_.publish(scan);
  }
  void own(const std::vector<float>& values) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(values.size());
    std::vector<float> sums;
    for (decltype(sums.size()) i = 0; i < values.size(); ++i) scan.ranges[i] = values[i];
    std::vector<decltype(sums)> all;
    all.push_back(sums);
    scan.angle_min = sizeof(decltype(values_)::value_type) + sizeof(values);
    pub_.publish(scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
  std::vector<float> values_;
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:24 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:34 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:39 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 1);
