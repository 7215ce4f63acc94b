// The function gets messages that stay what they are, so none of them is the one that is published.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("in", 1, &Node::add, this); }
  void add(const sensor_msgs::LaserScanConstPtr& in) {
    scans_.push_back(in);
    mean_.ranges.clear();
    mean_.ranges.resize(total(scans_));
    pub_.publish(mean_);
  }

 private:
  static std::size_t total(const std::vector<sensor_msgs::LaserScanConstPtr>& scans) {
    std::size_t sum = 0;
    for (const auto& scan : scans) sum += scan->ranges.size();
    return sum;
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("mean", 1);
  ros::Subscriber sub_;
  std::vector<sensor_msgs::LaserScanConstPtr> scans_;
  sensor_msgs::LaserScan mean_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/LaserScan shared 'in'
// publish src/node.cpp:14 sensor_msgs/LaserScan zero_copy 'mean'
// advertise src/node.cpp:24 sensor_msgs/LaserScan zero_copy 'mean'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { sub_ = nh_.subscribe("in", 1, &Node::add, this); }
// +  Node() { sub_ = tzc::subscribe(nh_, "in", 1, &Node::add, this); }
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("mean", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "mean", 1);
// -  sensor_msgs::LaserScan mean_;
// +  tzc::sensor_msgs::LaserScan mean_;
