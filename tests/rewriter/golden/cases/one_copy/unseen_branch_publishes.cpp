// Code that is not compiled publishes a stock message with the publisher, as it could with either class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 10); }
  void send(const sensor_msgs::ImageConstPtr& received) {
#ifdef OLD
    if (pub_.getNumSubscribers() > 0) pub_.publish(converted(received));
#else
    pub_.publish(received);
#endif
  }

 private:
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1019 no call that gives 'received' a message was found
// note src/node.cpp:9 TZC3002
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 10); }
// +  explicit Node(ros::NodeHandle& nh) { pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
