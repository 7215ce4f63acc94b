// Filters of clouds: each is made from the message, and read from shared memory where tzc/pcl.h is included.
#include <message_filters/subscriber.h>
#include <pcl_ros/point_cloud.h>
#include <pcl/point_cloud.h>

typedef message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> CloudFilter;

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : left_(nh, "left", 1), sync_(left_, right_, 10) {
    right_.subscribe(nh, "right", 1);
    sync_.registerCallback(boost::bind(&Node::callback, this, _1, _2));
  }
  void callback(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr&,
                const pcl::PointCloud<pcl::PointXYZ>::ConstPtr&) {}

 private:
  message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> left_;
  CloudFilter right_;
  message_filters::TimeSynchronizer<pcl::PointCloud<pcl::PointXYZ>, pcl::PointCloud<pcl::PointXYZ>> sync_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/PointCloud2 copied 'left' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
// subscribe src/node.cpp:11 sensor_msgs/PointCloud2 copied 'right' TZC2010 the callback takes a cloud of PCL, which is made from the shared bytes
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// +#include <tzc/pcl.h>
// -  message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> left_;
// -  CloudFilter right_;
// +  tzc::message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> left_;
// +  tzc::message_filters::Subscriber<pcl::PointCloud<pcl::PointXYZ>> right_;
