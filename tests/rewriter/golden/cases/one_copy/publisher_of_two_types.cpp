// One publisher is advertised with either of two types.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class Node {
 public:
  explicit Node(bool clouds) {
    if (clouds)
      pub_ = nh_.advertise<sensor_msgs::PointCloud2>("out", 1);
    else
      pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/PointCloud2 one_copy 'out'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -      pub_ = nh_.advertise<sensor_msgs::PointCloud2>("out", 1);
// +      pub_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, "out", 1);
// -      pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
// +      pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "out", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
