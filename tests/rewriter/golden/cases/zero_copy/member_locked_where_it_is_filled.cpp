// The function that fills the message takes the lock itself: nothing in front of it may touch the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

class Renderer {
 public:
  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void work() {
    std::lock_guard<std::mutex> lock(mutex_);
    image_.data.assign(100, 1);
  }
  void tick() {
    begin(image_);
    pub_.publish(image_);
    mutex_.unlock();
  }

 private:
  void begin(sensor_msgs::Image& image) {
    mutex_.lock();
    image.data.resize(100);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::mutex mutex_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Renderer() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -  void begin(sensor_msgs::Image& image) {
// +  void begin(tzc::sensor_msgs::Image& image) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
