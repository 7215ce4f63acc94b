// The struct has its content when it comes to the function that publishes the message in it: one copy, whoever made it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
};
struct Scan {
  sensor_msgs::Image image;
};

Frame make(int n) {
  Frame frame;
  frame.image.data.assign(n, 1);
  return frame;
}

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void result() {
    Frame frame = make(10);
    pub_.publish(frame.image);
  }
  void parameter(Scan& scan) { pub_.publish(scan.image); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1022 'frame' may be another object each time, with content outside shared memory
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'image' TZC1022 'scan' may be another object each time, with content outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
