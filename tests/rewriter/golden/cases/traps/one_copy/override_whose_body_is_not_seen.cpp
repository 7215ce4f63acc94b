// A pointer into the message is used behind a call of a virtual function; what overrides it has its body in a library.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
  void send() { pub_.publish(image_); }
  void step() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    done();
    *first = 1;
  }
  virtual void done() {}

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

class Sender : public Node {
 public:
  void done() override;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) { pub_ = nh.advertise<sensor_msgs::Image>("image", 1); }
// +  explicit Node(ros::NodeHandle& nh) { pub_ = tzc::advertise<sensor_msgs::Image>(nh, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
