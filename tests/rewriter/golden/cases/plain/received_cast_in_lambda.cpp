// The callback that casts is a lambda.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    sub_ = nh_.subscribe<sensor_msgs::Image>("image", 1, [](const sensor_msgs::ImageConstPtr& image) {
      boost::const_pointer_cast<sensor_msgs::Image>(image)->data[0] = 1;
    });
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
