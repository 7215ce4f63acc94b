// Loops that may leave elements as they are: they write fewer, or not each time, or end earlier.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <utility>
#include <vector>

float measure(int i);

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
  void fewer(int n) {
    a_.ranges.resize(n);
    for (int i = 0; i < n - 1; ++i) a_.ranges[i] = 1;
    pub_.publish(a_);
  }
  void not_the_first(int n) {
    b_.ranges.resize(n);
    for (int i = 1; i < n; ++i) b_.ranges[i] = 1;
    pub_.publish(b_);
  }
  void each_second(int n) {
    c_.ranges.resize(n);
    for (int i = 0; i < n; i += 2) c_.ranges[i] = 1;
    pub_.publish(c_);
  }
  void sometimes(int n) {
    d_.ranges.resize(n);
    for (int i = 0; i < n; ++i)
      if (i % 3) d_.ranges[i] = 1;
    pub_.publish(d_);
  }
  void may_throw(int n) {
    e_.ranges.resize(n);
    for (int i = 0; i < n; ++i) e_.ranges[i] = measure(i);
    pub_.publish(e_);
  }
  void ends_itself(int n) {
    f_.ranges.resize(n);
    for (int i = 0; i < n; ++i) f_.ranges[i] = std::exchange(i, n);
    pub_.publish(f_);
  }
  void other_count(int n) {
    g_.ranges.resize(n);
    n = 5;
    for (int i = 0; i < n; ++i) g_.ranges[i] = 1;
    pub_.publish(g_);
  }
  void other_sign(int n) {
    h_.ranges.resize(static_cast<unsigned>(n));
    for (int i = 0; i < n; ++i) h_.ranges[i] = 1;
    pub_.publish(h_);
  }
  void other_index(int n) {
    j_.ranges.resize(n);
    for (int i = 0; i < n; ++i) j_.ranges[n - 1] = 1;
    pub_.publish(j_);
  }
  void other_array(int n) {
    k_.ranges.resize(n);
    for (int i = 0; i < n; ++i) k_.intensities[i] = 1;
    k_.ranges[0] = 1;
    pub_.publish(k_);
  }
  void at_throws(int n, const std::vector<float>& values) {
    l_.ranges.resize(n);
    for (int i = 0; i < n; ++i) l_.ranges[i] = values.at(i);
    pub_.publish(l_);
  }
  void copies_of_elements(int n) {
    m_.ranges.resize(n);
    for (float range : m_.ranges) range = 1;
    m_.ranges[0] = 1;
    pub_.publish(m_);
  }
  void other_count_for_the_sister(int n) {
    o_.ranges.resize(n);
    o_.intensities.resize(n = 5);
    for (int i = 0; i < n; ++i) o_.ranges[i] = 1;
    pub_.publish(o_);
  }
  void leaves_behind_the_sister(int n) {
    p_.ranges.resize(n);
    p_.intensities.resize(n);
    for (int i = 0; i < n; ++i) {
      p_.intensities[i] = measure(i);
      p_.ranges[i] = 1;
    }
    pub_.publish(p_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_, j_, k_, l_, m_, o_, p_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:16 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 15 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:26 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 25 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:32 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 31 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:37 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 36 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:42 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 41 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:48 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 47 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:53 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 52 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:58 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 57 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:64 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 62 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:69 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 68 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:75 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 73 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:81 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 80 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:90 sensor_msgs/LaserScan one_copy 'scan' TZC1022 line 87 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 10); }
// -  ros::Publisher pub_;
// -  sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_, j_, k_, l_, m_, o_, p_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::LaserScan a_, b_, c_, d_, e_, f_, g_, h_, j_, k_, l_, m_, o_, p_;
