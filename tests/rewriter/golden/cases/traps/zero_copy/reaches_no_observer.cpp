// A const function of an object that keeps an observer, and an object that keeps none.
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
    image_.data.assign(100, 0);
    uint8_t* first = &image_.data[0];
    grid_.filter();
    *first = icp_.getFitnessScore() > 1;
    send();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  pcl::Icp icp_;
  pcl::VoxelGrid grid_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
