// The node handle comes from a function that sets what the arguments read.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { sub_ = configured().subscribe("image", queue_, &Node::callback, this); }
  void callback(const sensor_msgs::ImageConstPtr& image) { last_ = image->data.size(); }

 private:
  ros::NodeHandle& configured() {
    queue_ = 5;
    return nh_;
  }

  ros::NodeHandle nh_;
  ros::Subscriber sub_;
  int queue_ = 1;
  unsigned long last_ = 0;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image plain 'image' TZC2011 evaluating the node handle may change what the arguments read
