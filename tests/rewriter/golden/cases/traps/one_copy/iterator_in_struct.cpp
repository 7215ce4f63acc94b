// A struct of iterators.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

struct Xyz {
  explicit Xyz(sensor_msgs::PointCloud2& cloud) : x(cloud, "x"), y(cloud, "y") {}
  sensor_msgs::PointCloud2Iterator<float> x, y;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
  void publish() {
    cloud_.data.resize(100);
    Xyz xyz(cloud_);
    pub_.publish(cloud_);
    *xyz.x = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'cloud'
// publish src/node.cpp:16 sensor_msgs/PointCloud2 one_copy 'cloud' TZC1003 a pointer into its data is kept in a member
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "cloud", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
