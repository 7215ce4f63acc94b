// An iterator as a member.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
  void start() {
    cloud_.data.resize(100);
    x_ = std::make_shared<sensor_msgs::PointCloud2Iterator<float>>(cloud_, "x");
  }
  void publish() {
    **x_ = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::shared_ptr<sensor_msgs::PointCloud2Iterator<float>> x_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/PointCloud2 one_copy 'cloud'
// publish src/node.cpp:14 sensor_msgs/PointCloud2 one_copy 'cloud' TZC1003 a pointer into its data is kept in 'x_'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "cloud", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
