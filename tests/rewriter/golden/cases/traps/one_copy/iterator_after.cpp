// An iterator that is used after the publish.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
  void publish() {
    cloud_.data.resize(100);
    sensor_msgs::PointCloud2Iterator<float> x(cloud_, "x");
    pub_.publish(cloud_);
    *x = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/PointCloud2 one_copy 'cloud'
// publish src/node.cpp:11 sensor_msgs/PointCloud2 one_copy 'cloud' TZC1003 'x' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "cloud", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
