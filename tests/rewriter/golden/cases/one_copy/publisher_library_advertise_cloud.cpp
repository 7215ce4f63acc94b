// A base class of another package advertises a PCL cloud.
#include <other/library.h>
#include <pcl/point_cloud.h>
#include <pcl_ros/point_cloud.h>

class Child : public other::Nodelet {
 public:
  typedef pcl::PointCloud<pcl::PointXYZ> Cloud;
  explicit Child(ros::NodeHandle& nh) { points_ = advertise<Cloud>(nh, "points", 1); }
  void poll() {
    Cloud::Ptr cloud(new Cloud);
    points_.publish(cloud);
  }

 private:
  ros::Publisher points_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/PointCloud2 one_copy 'points'
// publish src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'points' its elements lie in memory of its library, and publishing copies them
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -  explicit Child(ros::NodeHandle& nh) { points_ = advertise<Cloud>(nh, "points", 1); }
// +  explicit Child(ros::NodeHandle& nh) { points_ = tzc::attach_publisher<Cloud>(advertise<Cloud>(nh, "points", 1)); }
// -  ros::Publisher points_;
// +  tzc::Publisher points_;
