// Loops that may read the elements that they write, by a pointer, a reference or another name; or write other arrays.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

struct Gain {
  float value;
};

struct Frame {
  sensor_msgs::LaserScan scan;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void by_itself(int n) {
    a_.ranges.resize(n);
    for (int i = 0; i < n; ++i) a_.ranges[i] = a_.ranges[n - 1 - i];
    pub_.publish(a_);
  }
  void added(int n) {
    b_.ranges.resize(n);
    for (int i = 0; i < n; ++i) b_.ranges[i] += 1;
    pub_.publish(b_);
  }
  void by_pointer(int n, const float* values) {
    c_.ranges.resize(n);
    for (int i = 0; i < n; ++i) c_.ranges[i] = values[i];
    pub_.publish(c_);
  }
  void by_reference(int n, const float& first) {
    d_.ranges.resize(n);
    for (int i = 0; i < n; ++i) d_.ranges[i] = first;
    pub_.publish(d_);
  }
  void by_second_name(int n) {
    const auto& same = e_.ranges;
    e_.ranges.resize(n);
    for (int i = 0; i < n; ++i) e_.ranges[i] = same[i];
    pub_.publish(e_);
  }
  void by_struct(int n, const Gain* gain) {
    f_.ranges.resize(n);
    for (float& range : f_.ranges) range = gain->value;
    pub_.publish(f_);
  }
  void range_loop(int n) {
    g_.ranges.resize(n);
    for (float& range : g_.ranges) range = range + 1;
    pub_.publish(g_);
  }
  template <class V>
  void by_any(int n, V& values) {
    h_.ranges.resize(n);
    for (int i = 0; i < n; ++i) h_.ranges[i] = values[i];
    pub_.publish(h_);
  }
  void shadowed(int i, int n) {
    frames_[i].scan.ranges.resize(n);
    for (int i = 0; i < n; ++i) frames_[i].scan.ranges[i] = 1;
    pub_.publish(frames_[0].scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_;
  Frame frames_[8];
};

void run(Node& node, std::vector<float>& values) {
  node.by_any(3, values);
}
//--- expected
// advertise src/node.cpp:17 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:26 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 25 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:31 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 30 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:36 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 35 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:42 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 41 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:47 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 46 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:52 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 51 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:58 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 57 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:63 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 62 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  sensor_msgs::LaserScan scan;
// +  tzc::sensor_msgs::LaserScan scan;
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_;
