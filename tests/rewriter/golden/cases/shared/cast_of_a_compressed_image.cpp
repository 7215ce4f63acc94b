// Another transport has a topic of its own: what a callback does with its images, no other one sees.
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Node {
 public:
  explicit Node(image_transport::ImageTransport& it)
      : takes_(it.subscribe("image", 1, &Node::take, this, image_transport::TransportHints("compressed"))),
        looks_(it.subscribe("image", 1, &Node::look, this)) {}

 private:
  void take(const sensor_msgs::ImageConstPtr& image) { kept_.swap(const_cast<sensor_msgs::Image&>(*image).data); }
  void look(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
  std::vector<uint8_t> kept_;
  image_transport::Subscriber takes_, looks_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image not_needed 'image' it asks for the transport 'compressed'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -        looks_(it.subscribe("image", 1, &Node::look, this)) {}
// +        looks_(tzc::image_transport::subscribe(it, "image", 1, &Node::look, this)) {}
