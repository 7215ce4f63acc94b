// Until the worker has ended the message is its own: nothing in front of the function that waits for it may touch the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

class Renderer {
 public:
  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void start() {
    worker_ = std::thread([this] { image_.data.assign(100, 1); });
  }
  void tick() {
    image_.header.stamp = ros::Time::now();
    end_work(); pub_.publish(image_);
  }

 private:
  void end_work() { worker_.join(); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::thread worker_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Renderer() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
