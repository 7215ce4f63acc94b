// What only reads through a pointer in one run, by itself or in a function of a library, may meet another thread that publishes: the
// original has no error there.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <mutex>
#include <numeric>

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
    sums_ = nh_.advertise<sensor_msgs::PointCloud2>("sums", 5);
    other::post([this] { look(); });
    other::post([this] { publish(); });
  }

 private:
  void count() {
    std::lock_guard<std::mutex> lock(mutex_);
    ++calls_;
  }
  void look() {
    count();
    unsigned char* data = &cloud_.data[0];
    for (int i = 0; i < 100; ++i)
      if (data[i] > 200) data[i] = 200;
    unsigned char* given = &sum_.data[0];
    if (calls_ > 200) given[1] = 1;
    total_ += std::accumulate(given, given + 100, 0);
  }
  void publish() {
    cloud_.data.assign(1000, 1);
    sum_.data.assign(1000, 1);
    count();
    pub_.publish(cloud_);
    sums_.publish(sum_);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_, sums_;
  sensor_msgs::PointCloud2 cloud_, sum_;
  std::mutex mutex_;
  int calls_ = 0, total_ = 0;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/PointCloud2 one_copy 'points'
// advertise src/node.cpp:14 sensor_msgs/PointCloud2 one_copy 'sums'
// publish src/node.cpp:37 sensor_msgs/PointCloud2 one_copy 'points' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
// publish src/node.cpp:38 sensor_msgs/PointCloud2 one_copy 'sums' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// -    sums_ = nh_.advertise<sensor_msgs::PointCloud2>("sums", 5);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "points", 5);
// +    sums_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "sums", 5);
// -  ros::Publisher pub_, sums_;
// +  tzc::Publisher pub_, sums_;
