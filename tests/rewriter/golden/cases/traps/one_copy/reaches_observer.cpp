// A library calls the observer that it was given elsewhere.
#include <pcl/registration.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
    icp_.registerVisualizationCallback([this](int) { send(); });
  }
  void send() { pub_.publish(image_); }
  void draw() {
    uint8_t* first = &image_.data[0];
    icp_.align();
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  pcl::Icp icp_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +    pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
