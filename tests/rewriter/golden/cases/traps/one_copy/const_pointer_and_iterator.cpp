// A const iterator reads what an iterator of the same cloud, made later, writes.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Node {
 public:
  void smooth() {
    sensor_msgs::PointCloud2ConstIterator<float> before(cloud_, "z");
    sensor_msgs::PointCloud2Iterator<float> z(cloud_, "z");
    for (++z; z != z.end(); ++z, ++before) *z = 0.5f * (*before + *z);
    pub_.publish(cloud_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 1);
  sensor_msgs::PointCloud2 cloud_;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'cloud' TZC1003 'before' points into its data and is used after its data was written to
// advertise src/node.cpp:17 sensor_msgs/PointCloud2 one_copy 'cloud'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::PointCloud2>("cloud", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "cloud", 1);
