// Two insertions at one place: a statement, and a prefix of the statement behind it.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Node {
 public:
  void tick() {
    sensor_msgs::PointCloud2Modifier modifier(cloud_);
    modifier.setPointCloud2FieldsByString(1, "xyz");
    modifier.resize(1000);
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/PointCloud2 zero_copy 'points'
// advertise src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/PointCloud2.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// -    sensor_msgs::PointCloud2Modifier modifier(cloud_);
// +    tzc::sensor_msgs::PointCloud2Modifier modifier(cloud_);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 1);
// +  tzc::sensor_msgs::PointCloud2 cloud_;
