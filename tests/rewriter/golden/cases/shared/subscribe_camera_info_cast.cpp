// Const is cast away from the calibration that comes with the image, which shares no memory.
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Node {
 public:
  explicit Node(image_transport::ImageTransport& it)
      : camera_(it.subscribeCamera("image", 1, &Node::on_camera, this)) {}

 private:
  void on_camera(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::CameraInfoConstPtr& info) {
    const_cast<sensor_msgs::CameraInfo&>(*info).D.resize(image->data.empty() ? 0 : 5);
  }
  image_transport::CameraSubscriber camera_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -      : camera_(it.subscribeCamera("image", 1, &Node::on_camera, this)) {}
// +      : camera_(tzc::image_transport::subscribeCamera(it, "image", 1, &Node::on_camera, this)) {}
