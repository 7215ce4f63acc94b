// Each call makes an object of its own, and a library may run the other one in between: the message is new all the same, and
// is copied each time.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Renderer {
 public:
  explicit Renderer(ros::Publisher& pub) : pub_(pub) {}
  void render(int n) {
    image_.data.assign(n, 1);
    other::poll();
    pub_.publish(image_);
  }

 private:
  ros::Publisher& pub_;
  sensor_msgs::Image image_;
};

class Node {
 public:
  void first(const ros::TimerEvent&) {
    Renderer renderer(pub_);
    renderer.render(1000);
  }
  void second(const ros::TimerEvent&) {
    Renderer renderer(pub_);
    renderer.render(2000);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// advertise src/node.cpp:34 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Renderer(ros::Publisher& pub) : pub_(pub) {}
// +  explicit Renderer(tzc::Publisher& pub) : pub_(pub) {}
// -  ros::Publisher& pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher& pub_;
// +  tzc::sensor_msgs::Image image_;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
