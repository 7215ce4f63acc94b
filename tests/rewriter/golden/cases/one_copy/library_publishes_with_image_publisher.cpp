// The same with publishers of image_transport.
#include <image_transport/image_transport.h>
#include <sensor_msgs/Image.h>

#include <any>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh) : transport_(nh) {
    kept_ = transport_.advertise("image", 1);
    camera_ = transport_.advertiseCamera("camera", 1);
  }
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(640 * 480);
    std::any_cast<image_transport::Publisher&>(kept_).publish(image);
    std::any_cast<image_transport::CameraPublisher&>(camera_).publish(image, sensor_msgs::CameraInfo());
  }

 private:
  image_transport::ImageTransport transport_;
  std::any kept_, camera_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1010 it becomes part of 'kept_', whose type does not tell
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'camera' TZC1010 it becomes part of 'camera_', whose type does not tell
// publish src/node.cpp:16 sensor_msgs/Image zero_copy
// publish src/node.cpp:17 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    kept_ = transport_.advertise("image", 1);
// -    camera_ = transport_.advertiseCamera("camera", 1);
// +    kept_ = tzc::image_transport::attached(transport_.advertise("image", 1));
// +    camera_ = tzc::image_transport::attached(transport_.advertiseCamera("camera", 1));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    std::any_cast<image_transport::Publisher&>(kept_).publish(image);
// -    std::any_cast<image_transport::CameraPublisher&>(camera_).publish(image, sensor_msgs::CameraInfo());
// +    tzc::image_transport::publish(std::any_cast<image_transport::Publisher&>(kept_), image);
// +    tzc::image_transport::publish(std::any_cast<image_transport::CameraPublisher&>(camera_), image, sensor_msgs::CameraInfo());
