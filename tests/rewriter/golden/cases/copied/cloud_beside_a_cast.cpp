// Const is cast away from some message of the type: the callback has a cloud that is made from the bytes.
#include <pcl_ros/point_cloud.h>
#include <pcl/point_cloud.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("points", 1, &Node::take, this)) {}
  static void clear(void* user) { static_cast<sensor_msgs::PointCloud2*>(user)->data.clear(); }

 private:
  void take(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr&) {}
  ros::Subscriber subscriber_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/PointCloud2 copied 'points' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("points", 1, &Node::take, this)) {}
// +  explicit Node(ros::NodeHandle& nh) : subscriber_(tzc::subscribe(nh, "points", 1, &Node::take, this)) {}
