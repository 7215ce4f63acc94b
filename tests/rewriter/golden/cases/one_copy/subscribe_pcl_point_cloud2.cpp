// PCL's own message: roscpp sends it as a PointCloud2.
#include <pcl_ros/point_cloud.h>
#include <pcl/point_cloud.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::PointCloud2>("out", 1);
    sub_ = nh.subscribe("points", 1, &Node::take, this);
  }

 private:
  void take(const boost::shared_ptr<const pcl::PCLPointCloud2>& cloud) {
    pub_.publish(cloud);
    pub_.publish(*cloud);
  }
  ros::Subscriber sub_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/PointCloud2 one_copy 'out'
// subscribe src/node.cpp:9 sensor_msgs/PointCloud2 copied 'points' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
// publish src/node.cpp:14 sensor_msgs/PointCloud2 one_copy 'out' its elements lie in memory of its library, and publishing copies them
// publish src/node.cpp:15 sensor_msgs/PointCloud2 one_copy 'out' its elements lie in memory of its library, and publishing copies them
//
// +++ src/node.cpp
// +#include <tzc/pcl.h>
// +#include <tzc/ros.h>
// -    pub_ = nh.advertise<sensor_msgs::PointCloud2>("out", 1);
// -    sub_ = nh.subscribe("points", 1, &Node::take, this);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh, "out", 1);
// +    sub_ = tzc::subscribe(nh, "points", 1, &Node::take, this);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
