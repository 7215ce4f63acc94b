// A vector that is made on the spot, and what the array's own assign would not do: its elements are read while it changes, or
// what is meant changes before it does.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void shifted(int n) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(n);
    scan.ranges = std::vector<float>(scan.ranges.begin() + 1, scan.ranges.end());
    pub_.publish(scan);
  }
  void by_reference(int n) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(n);
    const std::vector<float>& own = scan.ranges;
    scan.ranges = std::vector<float>(own.rbegin(), own.rend());
    pub_.publish(scan);
  }
  void by_pointer_to_smaller(const unsigned char* first, int n) {
    sensor_msgs::LaserScan scan;
    scan.ranges = std::vector<float>(first, first + n);
    pub_.publish(scan);
  }
  void listed() {
    sensor_msgs::LaserScan scan;
    scan.ranges = std::vector<float>{1, 2, 3};
    pub_.publish(scan);
  }
  int renewed() {
    scan_.reset(new sensor_msgs::LaserScan);
    return 9;
  }
  void of_call() {
    scan_->ranges = std::vector<float>(renewed());
    pub_.publish(scan_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan::Ptr scan_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:15 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 14 gives it elements that lie outside shared memory
// publish src/node.cpp:22 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is used after its data was written to
// publish src/node.cpp:27 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 26 gives it elements that lie outside shared memory
// publish src/node.cpp:32 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 31 gives it elements that lie outside shared memory
// publish src/node.cpp:40 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 39 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
// -    scan_.reset(new sensor_msgs::LaserScan);
// +    scan_.reset(new tzc::sensor_msgs::LaserScan);
// +    pub_.allocate(*scan_);
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan::Ptr scan_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan::Ptr scan_;
