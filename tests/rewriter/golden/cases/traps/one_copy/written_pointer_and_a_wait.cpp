// Between a pointer or an iterator and what is written through it another thread may publish the message: the waits order them.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
    others_ = nh_.advertise<sensor_msgs::PointCloud2>("others", 5);
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
    other_.data.resize(800);
    sensor_msgs::PointCloud2Iterator<float> x(other_, "x");
    is_begun_ = true;
    while (!is_published_) continue;
    *x = 1;
  }
  void publish() {
    pub_.publish(cloud_);
    {
      std::lock_guard<std::mutex> lock(mutex_);
      published_ = true;
      condition_.notify_one();
    }
    while (!is_begun_) continue;
    others_.publish(other_);
    is_published_ = true;
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_, others_;
  sensor_msgs::PointCloud2 cloud_, other_;
  std::mutex mutex_;
  std::condition_variable condition_;
  bool published_ = false;
  std::atomic<bool> is_begun_{false}, is_published_{false};
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/PointCloud2 one_copy 'points'
// advertise src/node.cpp:14 sensor_msgs/PointCloud2 one_copy 'others'
// publish src/node.cpp:33 sensor_msgs/PointCloud2 one_copy 'points' TZC1003 'data' points into its data and is used after the message may have been published
// publish src/node.cpp:40 sensor_msgs/PointCloud2 one_copy 'others' TZC1003 'x' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// -    others_ = nh_.advertise<sensor_msgs::PointCloud2>("others", 5);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "points", 5);
// +    others_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "others", 5);
// -  ros::Publisher pub_, others_;
// +  tzc::Publisher pub_, others_;
