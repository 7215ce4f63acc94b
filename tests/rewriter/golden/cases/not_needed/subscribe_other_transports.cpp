// Hints that ask for what shares no memory; the transport is a constant, or the run tells.
#include <image_transport/subscriber_filter.h>
#include <ros/ros.h>

class Node {
 public:
  explicit Node(image_transport::ImageTransport& it) {
    image_transport::TransportHints hints("theora");
    first_ = it.subscribe("first", 1, &Node::on_image, this, image_transport::TransportHints("compressed"));
    second_ = it.subscribe("second", 1, &Node::on_image, this, hints);
    filter_.subscribe(it, "depth", 1, image_transport::TransportHints("compressedDepth"));
    third_ = nh_.subscribe("third", 1, &Node::on_image, this, ros::TransportHints().unreliable().reliable());
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}

 private:
  ros::NodeHandle nh_;
  image_transport::Subscriber first_, second_;
  image_transport::SubscriberFilter filter_;
  ros::Subscriber third_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image not_needed 'first' it asks for the transport 'compressed'
// subscribe src/node.cpp:10 sensor_msgs/Image not_needed 'second' it asks for the transport 'theora'
// subscribe src/node.cpp:11 sensor_msgs/Image not_needed 'depth' it asks for the transport 'compressedDepth'
// subscribe src/node.cpp:12 sensor_msgs/Image not_needed 'third' it asks for UDPROS
