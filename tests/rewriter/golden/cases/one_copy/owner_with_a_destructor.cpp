// A message that is published is part of an object whose destructor does something, and keeps that object alive.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  explicit Frame(int& live) : live_(live) { ++live_; }
  ~Frame() { --live_; }
  int& live_;
  sensor_msgs::Image image;
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void tick() {
    if (live_ > 2) return;
    boost::shared_ptr<Frame> frame = boost::make_shared<Frame>(live_);
    frame->image.data.resize(40000);
    pub_.publish(sensor_msgs::ImagePtr(frame, &frame->image));
  }

 private:
  int live_ = 0;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1001 the destructor of its owner shows when it is no longer held
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "image", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
