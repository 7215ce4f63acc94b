// A function of the package publishes what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    send(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// -  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// +  void send(const tzc::sensor_msgs::Image& image) { pub_.publish(image); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
