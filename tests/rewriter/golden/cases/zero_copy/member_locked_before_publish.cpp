// Another thread fills the message under the lock: nothing in front of it may touch the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>
#include <thread>

class Renderer {
 public:
  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {
    image_.header.frame_id = "camera";
    worker_ = std::thread([this] { work(); });
  }
  ~Renderer() { worker_.join(); }
  void work() {
    while (ros::ok()) {
      std::lock_guard<std::mutex> lock(mutex_);
      image_.data.assign(100, 1);
    }
  }
  void tick() {
    if (image_.header.frame_id.empty()) return;
    image_.header.stamp = ros::Time::now();
    std::lock_guard<std::mutex> lock(mutex_); pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::mutex mutex_;
  std::thread worker_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {
// +  Renderer() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
