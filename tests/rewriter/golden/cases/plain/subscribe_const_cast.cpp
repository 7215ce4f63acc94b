// The callback casts const away: left alone.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = nh_.subscribe("image", 1, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    sensor_msgs::Image& writable = const_cast<sensor_msgs::Image&>(*image);
    writable.data[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
