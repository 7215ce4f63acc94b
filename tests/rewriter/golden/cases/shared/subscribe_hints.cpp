// Hints that leave the transport as it is, or of which only the run tells.
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Node {
 public:
  Node(image_transport::ImageTransport& it, const std::string& transport) {
    first_ = it.subscribe("first", 1, &Node::on_image, this, image_transport::TransportHints(transport));
    second_ = nh_.subscribe("second", 1, &Node::on_image, this, ros::TransportHints().tcpNoDelay());
    third_ = nh_.subscribe("third", 1, &Node::on_image, this, ros::TransportHints().reliable().unreliable());
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}

 private:
  ros::NodeHandle nh_;
  image_transport::Subscriber first_;
  ros::Subscriber second_, third_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'first'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'second'
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'third'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// -    first_ = it.subscribe("first", 1, &Node::on_image, this, image_transport::TransportHints(transport));
// -    second_ = nh_.subscribe("second", 1, &Node::on_image, this, ros::TransportHints().tcpNoDelay());
// -    third_ = nh_.subscribe("third", 1, &Node::on_image, this, ros::TransportHints().reliable().unreliable());
// +    first_ = tzc::image_transport::subscribe(it, "first", 1, &Node::on_image, this, image_transport::TransportHints(transport));
// +    second_ = tzc::subscribe(nh_, "second", 1, &Node::on_image, this, ros::TransportHints().tcpNoDelay());
// +    third_ = tzc::subscribe(nh_, "third", 1, &Node::on_image, this, ros::TransportHints().reliable().unreliable());
