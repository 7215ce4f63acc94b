// Between the pointer and what is written through it another thread may publish the message: the wait orders them.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <condition_variable>
#include <mutex>

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
    other::post([this] { fill(); });
    other::post([this] { publish(); });
  }

 private:
  void fill() {
    cloud_.data.resize(800);
    unsigned char* data = &cloud_.data[0];
    std::unique_lock<std::mutex> lock(mutex_);
    while (!published_) condition_.wait(lock);
    *data = 1;
  }
  void publish() {
    pub_.publish(cloud_);
    std::lock_guard<std::mutex> lock(mutex_);
    published_ = true;
    condition_.notify_one();
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::mutex mutex_;
  std::condition_variable condition_;
  bool published_ = false;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'points'
// publish src/node.cpp:26 sensor_msgs/PointCloud2 one_copy 'points' TZC1003 'data' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "points", 5);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
