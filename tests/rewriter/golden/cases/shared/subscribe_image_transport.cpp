// image_transport subscribe and subscribeCamera.
#include <image_transport/image_transport.h>

void on_image(const sensor_msgs::ImageConstPtr& image) {}

class Node {
 public:
  explicit Node(boost::shared_ptr<image_transport::ImageTransport> it) {
    sub_ = it->subscribe("image", 1, &Node::on_image, this);
    camera_ = it->subscribeCamera("camera", 1, &Node::on_camera, this, image_transport::TransportHints("raw"));
    function_ = it->subscribe("image", 1, ::on_image);
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}
  void on_camera(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::CameraInfoConstPtr& info) {}

 private:
  image_transport::Subscriber sub_, function_;
  image_transport::CameraSubscriber camera_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'camera'
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -    sub_ = it->subscribe("image", 1, &Node::on_image, this);
// -    camera_ = it->subscribeCamera("camera", 1, &Node::on_camera, this, image_transport::TransportHints("raw"));
// -    function_ = it->subscribe("image", 1, ::on_image);
// +    sub_ = tzc::image_transport::subscribe(*it, "image", 1, &Node::on_image, this);
// +    camera_ = tzc::image_transport::subscribeCamera(*it, "camera", 1, &Node::on_camera, this, image_transport::TransportHints("raw"));
// +    function_ = tzc::image_transport::subscribe(*it, "image", 1, ::on_image);
