// What stands between a resize and the loop or memcpy that writes the elements may throw: a sister's size that no vector has, a cast to
// a reference. The next message would have what is there then. A sister of the same size comes back, as the first did.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include <cstring>
#include <vector>

struct Source {
  virtual ~Source() {}
};

struct Frame : Source {
  uint8_t pixels[100];
};

class Node {
 public:
  Node() {
    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
    images_ = nh_.advertise<sensor_msgs::Image>("image", 10);
  }
  void another_size(int n, int m) {
    a_.ranges.resize(n);
    a_.intensities.resize(m);
    for (int i = 0; i < n; ++i) a_.ranges[i] = 1;
    scans_.publish(a_);
  }
  void smaller_than_none(int n, const std::vector<float>& values) {
    b_.ranges.resize(n);
    b_.intensities.resize(values.size() - 10);
    for (int i = 0; i < n; ++i) b_.ranges[i] = 1;
    scans_.publish(b_);
  }
  void size_that_changed(int n) {
    c_.ranges.resize(n);
    n = -1;
    c_.intensities.resize(n);
    for (float& range : c_.ranges) range = 1;
    scans_.publish(c_);
  }
  void negative() {
    d_.ranges.resize(100);
    d_.intensities.resize(-1);
    for (int i = 0; i < 100; ++i) d_.ranges[i] = 1;
    scans_.publish(d_);
  }
  void by_cast(Source& source) {
    image_.data.resize(100);
    memcpy(&image_.data[0], dynamic_cast<Frame&>(source).pixels, 100);
    images_.publish(image_);
  }
  void same_size(int n) {
    e_.ranges.resize(n);
    e_.intensities.resize(n);
    for (int i = 0; i < n; ++i) {
      e_.ranges[i] = 1;
      e_.intensities[i] = 2;
    }
    scans_.publish(e_);
  }
  void known_size(int n) {
    f_.ranges.resize(n);
    f_.intensities.resize(0);
    for (int i = 0; i < n; ++i) f_.ranges[i] = 1;
    scans_.publish(f_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher scans_, images_;
  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:21 sensor_msgs/LaserScan zero_copy 'scan'
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:28 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 27 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:34 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 33 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:41 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 40 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:47 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 46 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:52 sensor_msgs/Image one_copy 'image' TZC1022 line 51 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:61 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:67 sensor_msgs/LaserScan zero_copy 'scan'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
// -    images_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +    scans_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10);
// +    images_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// -    e_.ranges.resize(n);
// -    e_.intensities.resize(n);
// +    e_.ranges.resize(n, tzc::uninitialized);
// +    e_.intensities.resize(n, tzc::uninitialized);
// -    f_.ranges.resize(n);
// +    f_.ranges.resize(n, tzc::uninitialized);
// -  ros::Publisher scans_, images_;
// -  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher scans_, images_;
// +  tzc::sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_;
// +  tzc::sensor_msgs::Image image_;
