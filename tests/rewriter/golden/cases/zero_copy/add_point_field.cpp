// A function of sensor_msgs that adds a field to a cloud, and leaves its points.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Lidar {
 public:
  void send() {
    cloud_.fields.clear();
    cloud_.point_step = addPointField(cloud_, "x", 1, 7, 0);
    cloud_.data.clear();
    cloud_.data.resize(1000 * cloud_.point_step);
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/PointCloud2 zero_copy 'points'
// advertise src/node.cpp:18 sensor_msgs/PointCloud2 zero_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/PointCloud2.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// -    cloud_.point_step = addPointField(cloud_, "x", 1, 7, 0);
// +    cloud_.point_step = tzc::sensor_msgs::addPointField(cloud_, "x", 1, 7, 0);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 1);
// +  tzc::sensor_msgs::PointCloud2 cloud_;
