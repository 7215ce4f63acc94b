// A publisher that nothing publishes with gains nothing, and stays.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::Image>("image", 1);
    debug_ = nh.advertise<sensor_msgs::Image>("debug", 1);
  }
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pub_.publish(image);
    // debug_.publish(image);
    if (debug_.getNumSubscribers() > 0) return;
  }

 private:
  ros::Publisher pub_;
  ros::Publisher debug_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:9 sensor_msgs/Image not_needed 'debug' nothing in the package publishes with it
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = nh.advertise<sensor_msgs::Image>("image", 1);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
