// A virtual function runs between the place where the message is made and its publish. The class is not exported, so all that may
// override it was seen: none takes a lock, behind which another thread could have replaced the publisher.
#include <mutex>
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Camera {
 public:
  void open(ros::NodeHandle& nh) {
    std::lock_guard<std::mutex> lock(mutex_);
    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
  }
  void step(const cv_bridge::CvImagePtr& image) {
    sensor_msgs::ImagePtr msg;
    msg = image->toImageMsg();
    note(msg->width);
    pub_.publish(msg);
  }
  virtual void note(int width) { width_ = width; }

 private:
  image_transport::Publisher pub_;
  std::mutex mutex_;
  int width_ = 0;
};

class Louder : public Camera {
 public:
  void note(int width) override { ROS_INFO("%d", width); }
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
// +    pub_ = tzc::image_transport::advertise(image_transport::ImageTransport(nh), "image", 1);
// -    sensor_msgs::ImagePtr msg;
// -    msg = image->toImageMsg();
// +    tzc::sensor_msgs::ImagePtr msg;
// +    msg = tzc::cv_bridge::to_image_msg(*image, pub_);
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
