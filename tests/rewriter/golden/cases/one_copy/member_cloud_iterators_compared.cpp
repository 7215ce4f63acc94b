// Comparing iterators keeps nothing: what is left is the copy of the points that the member keeps from one publish to the next.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Node {
 public:
  void tick() {
    sensor_msgs::PointCloud2Modifier modifier(cloud_);
    modifier.setPointCloud2FieldsByString(1, "xyz");
    modifier.resize(1000);
    for (sensor_msgs::PointCloud2Iterator<float> x(cloud_, "x"); x != x.end(); ++x) *x = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/PointCloud2 one_copy 'points' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:18 sensor_msgs/PointCloud2 one_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/PointCloud2.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// -    sensor_msgs::PointCloud2Modifier modifier(cloud_);
// +    tzc::sensor_msgs::PointCloud2Modifier modifier(cloud_);
// -    for (sensor_msgs::PointCloud2Iterator<float> x(cloud_, "x"); x != x.end(); ++x) *x = 1;
// +    for (tzc::sensor_msgs::PointCloud2Iterator<float> x(cloud_, "x"); x != x.end(); ++x) *x = 1;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 1);
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 1);
// +  tzc::sensor_msgs::PointCloud2 cloud_;
