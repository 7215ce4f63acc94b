// The function of a library may read through the pointer, in a run that does not write and may meet another thread that publishes.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <mutex>
#include <numeric>

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
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
      if (calls_ > 200) data[i] = 200;
    sum_ += std::accumulate(data, data + 100, 0);
  }
  void publish() {
    cloud_.data.assign(1000, 1);
    count();
    pub_.publish(cloud_);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::mutex mutex_;
  int calls_ = 0, sum_ = 0;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'points'
// publish src/node.cpp:32 sensor_msgs/PointCloud2 one_copy 'points' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "points", 5);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
