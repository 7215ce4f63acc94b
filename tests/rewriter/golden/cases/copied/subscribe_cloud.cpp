// The callback takes a pcl::PointCloud: its type stands in the callback's signature.
#include <pcl_ros/point_cloud.h>
#include <pcl/point_cloud.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    by_pointer_ = nh.subscribe("points", 1, &Node::take, this);
    by_name_ = nh.subscribe<pcl::PointCloud<pcl::PointXYZ>>("points", 1, &Node::take, this);
  }

 private:
  void take(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr&) {}
  ros::Subscriber by_pointer_, by_name_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/PointCloud2 copied 'points' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
// subscribe src/node.cpp:9 sensor_msgs/PointCloud2 copied 'points' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -    by_pointer_ = nh.subscribe("points", 1, &Node::take, this);
// -    by_name_ = nh.subscribe<pcl::PointCloud<pcl::PointXYZ>>("points", 1, &Node::take, this);
// +    by_pointer_ = tzc::subscribe(nh, "points", 1, &Node::take, this);
// +    by_name_ = tzc::subscribe<pcl::PointCloud<pcl::PointXYZ>>(nh, "points", 1, &Node::take, this);
