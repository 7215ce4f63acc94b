// The function that fills the message takes the lock itself: in front of the call allocate would be in front of the lock.
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
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1019 other threads may use it until a lock is taken, and allocate would come before that
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Renderer() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Renderer() : pub_(tzc::advertise<sensor_msgs::Image>(nh_, "image", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
