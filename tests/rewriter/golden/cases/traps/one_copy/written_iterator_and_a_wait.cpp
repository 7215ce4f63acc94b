// Between the iterator and what is written through it another thread may publish the message: the wait orders them.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <atomic>

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
    sensor_msgs::PointCloud2Iterator<float> x(cloud_, "x");
    is_begun_ = true;
    while (!is_published_) continue;
    *x = 1;
  }
  void publish() {
    while (!is_begun_) continue;
    pub_.publish(cloud_);
    is_published_ = true;
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::atomic<bool> is_begun_{false}, is_published_{false};
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/PointCloud2 one_copy 'points'
// publish src/node.cpp:26 sensor_msgs/PointCloud2 one_copy 'points' TZC1003 'x' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "points", 5);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
