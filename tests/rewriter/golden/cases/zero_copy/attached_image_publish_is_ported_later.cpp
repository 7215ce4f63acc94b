// An earlier run published with image publishers that can be ported now.
#include <image_transport/image_transport.h>
#include <sensor_msgs/Image.h>
#include <tzc/image_transport.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh) : transport_(nh) {
    pub_ = transport_.advertise("image", 10);
    camera_ = transport_.advertiseCamera("camera", 10);
  }
  void tick() {
    tzc::sensor_msgs::Image image;
    tzc::allocate(image);
    image.data.resize(640 * 480);
    tzc::image_transport::publish(pub_, image);
    tzc::image_transport::publish(camera_, image, info_);
  }

 private:
  image_transport::ImageTransport transport_;
  image_transport::Publisher pub_;
  image_transport::CameraPublisher camera_;
  sensor_msgs::CameraInfo info_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'camera'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'camera'
//
// +++ src/node.cpp
// -    pub_ = transport_.advertise("image", 10);
// -    camera_ = transport_.advertiseCamera("camera", 10);
// +    pub_ = tzc::image_transport::advertise(transport_, "image", 10);
// +    camera_ = tzc::image_transport::advertiseCamera(transport_, "camera", 10);
// -    tzc::image_transport::publish(pub_, image);
// -    tzc::image_transport::publish(camera_, image, info_);
// +    pub_.publish(image);
// +    camera_.publish(image, info_);
// -  image_transport::Publisher pub_;
// -  image_transport::CameraPublisher camera_;
// +  tzc::image_transport::Publisher pub_;
// +  tzc::image_transport::CameraPublisher camera_;
