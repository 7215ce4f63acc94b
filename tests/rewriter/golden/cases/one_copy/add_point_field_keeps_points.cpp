// The cloud gets a field, and keeps its points: that they are written again costs a copy.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Lidar {
 public:
  void send() {
    addPointField(cloud_, "x", 1, 7, 0);
    cloud_.data[0] = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/PointCloud2 one_copy 'points' TZC1022 line 10 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:16 sensor_msgs/PointCloud2 one_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/PointCloud2.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// -    addPointField(cloud_, "x", 1, 7, 0);
// +    tzc::sensor_msgs::addPointField(cloud_, "x", 1, 7, 0);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 1);
// +  tzc::sensor_msgs::PointCloud2 cloud_;
