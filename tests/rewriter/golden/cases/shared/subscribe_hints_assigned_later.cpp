// Which transport the hints ask for is known only when the program runs.
#include <image_transport/subscriber_filter.h>
#include <ros/ros.h>

class Node {
 public:
  Node(image_transport::ImageTransport& it, bool is_raw) {
    image_transport::TransportHints hints("compressed");
    if (is_raw) hints = image_transport::TransportHints("raw");
    sub_ = it.subscribe("image", 1, &Node::on_image, this, hints);
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}

 private:
  image_transport::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -    sub_ = it.subscribe("image", 1, &Node::on_image, this, hints);
// +    sub_ = tzc::image_transport::subscribe(it, "image", 1, &Node::on_image, this, hints);
