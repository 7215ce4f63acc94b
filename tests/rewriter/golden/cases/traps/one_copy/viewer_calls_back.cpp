// PCL calls nothing, but its viewer does, and writes to what was published.
#include <pcl/visualization/pcl_visualizer.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::Image>("image", 1);
    viewer_.registerPointPickingCallback([this] {
      if (!image_.data.empty()) image_.data[0] = 1;
    });
  }
  void show() {
    image_.data.assign(100, 1);
    pub_.publish(image_);
    viewer_.spinOnce();
    image_.data.clear();
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  pcl::visualization::PCLVisualizer viewer_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1022 line 11 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh.advertise<sensor_msgs::Image>("image", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
