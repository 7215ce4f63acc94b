// The function that runs before the publish takes no lock, but what overrides it in another file does: behind the lock another thread
// has replaced the publisher.
#include "camera.h"

void Camera::step(const cv_bridge::CvImagePtr& image) {
  sensor_msgs::ImagePtr msg;
  msg = image->toImageMsg();
  note(msg->width);
  pub_.publish(msg);
}
//--- src/louder.cpp
#include <mutex>
#include "camera.h"

class Louder : public Camera {
 public:
  void open(ros::NodeHandle& nh) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
  }
  void note(int) override { std::lock_guard<std::mutex> lock(mutex_); }

 private:
  std::mutex mutex_;
};
//--- src/camera.h
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Camera {
 public:
  void step(const cv_bridge::CvImagePtr& image);
  virtual void note(int) {}

 protected:
  image_transport::Publisher pub_;
};
//--- expected
// advertise src/louder.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
//
// +++ src/camera.h
// +#include <tzc/image_transport.h>
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
//
// +++ src/louder.cpp
// +#include <tzc/image_transport.h>
// -    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
// +    pub_ = tzc::image_transport::advertise(image_transport::ImageTransport(nh), "image", 1);
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::ImagePtr msg;
// -  msg = image->toImageMsg();
// +  tzc::sensor_msgs::ImagePtr msg;
// +  msg = tzc::cv_bridge::to_image_msg(*image, tzc::Publisher());
