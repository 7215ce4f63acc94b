// The callback that casts is part of options.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    ros::SubscribeOptions options;
    options.init<sensor_msgs::Image>("image", 1, boost::bind(&Node::callback, this, _1));
    sub_ = nh_.subscribe(options);
  }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    boost::const_pointer_cast<sensor_msgs::Image>(image)->data[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image plain TZC2002 const is cast away from it
