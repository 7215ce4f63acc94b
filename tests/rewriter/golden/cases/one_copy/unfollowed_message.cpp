// Nothing shows which message a function's iterator leads to: it may be any of the type. A closure's reference is followed.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

class Node {
 public:
  Node() : frames_(2), scans_(2) {
    image_pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
    other_pub_ = nh_.advertise<sensor_msgs::Image>("other", 1);
    scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
    plain_pub_ = nh_.advertise<sensor_msgs::PointCloud2>("plain", 1);
  }
  std::vector<sensor_msgs::Image>::iterator oldest() {
    auto found = frames_.begin();
    if (n_ % 2) ++found;
    return found;
  }
  void image() {
    frames_[0].data = std::vector<unsigned char>(100, 0);
    frames_[0].data.clear();
    frames_[0].data.resize(100);
    image_pub_.publish(frames_[0]);
    oldest()->data[0] = n_++;
  }
  void other() {
    last_.data.clear();
    last_.data.resize(100);
    other_pub_.publish(last_);
  }
  void scan() {
    const auto choose = [this]() -> sensor_msgs::LaserScan& {
      if (n_ % 2) return scans_[0];
      return scans_[1];
    };
    scan_pub_.publish(choose());
    if (!scans_[1].ranges.empty()) scans_[1].ranges[0] = 1;
  }
  void plain() {
    cloud_.data.clear();
    cloud_.data.resize(100);
    plain_pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher image_pub_, other_pub_, scan_pub_, plain_pub_;
  std::vector<sensor_msgs::Image> frames_;
  std::vector<sensor_msgs::LaserScan> scans_;
  sensor_msgs::Image last_;
  sensor_msgs::PointCloud2 cloud_;
  int n_ = 0;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'other'
// advertise src/node.cpp:14 sensor_msgs/LaserScan one_copy 'scan'
// advertise src/node.cpp:15 sensor_msgs/PointCloud2 zero_copy 'plain'
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'image' TZC1022 line 27 of node.cpp uses a sensor_msgs/Image, and nothing shows which: it may be this one, and be written to after this publish
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'other' TZC1022 line 27 of node.cpp uses a sensor_msgs/Image, and nothing shows which: it may be this one, and be written to after this publish
// publish src/node.cpp:39 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 40 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:45 sensor_msgs/PointCloud2 zero_copy 'plain'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    image_pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -    other_pub_ = nh_.advertise<sensor_msgs::Image>("other", 1);
// -    scan_pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1);
// -    plain_pub_ = nh_.advertise<sensor_msgs::PointCloud2>("plain", 1);
// +    image_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +    other_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "other", 1);
// +    scan_pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 1);
// +    plain_pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "plain", 1);
// -  std::vector<sensor_msgs::Image>::iterator oldest() {
// +  std::vector<tzc::sensor_msgs::Image>::iterator oldest() {
// -    const auto choose = [this]() -> sensor_msgs::LaserScan& {
// +    const auto choose = [this]() -> tzc::sensor_msgs::LaserScan& {
// -  ros::Publisher image_pub_, other_pub_, scan_pub_, plain_pub_;
// -  std::vector<sensor_msgs::Image> frames_;
// -  std::vector<sensor_msgs::LaserScan> scans_;
// -  sensor_msgs::Image last_;
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher image_pub_, other_pub_, scan_pub_, plain_pub_;
// +  std::vector<tzc::sensor_msgs::Image> frames_;
// +  std::vector<tzc::sensor_msgs::LaserScan> scans_;
// +  tzc::sensor_msgs::Image last_;
// +  tzc::sensor_msgs::PointCloud2 cloud_;
