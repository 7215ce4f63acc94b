// Null pointers that are written with a message's type lead to no message that could be written to.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::on_image, this)) {}

 private:
  void on_image(const sensor_msgs::ImageConstPtr& image) {
    const std::size_t nothing = size_of(sensor_msgs::ImagePtr(nullptr)) + size_at((sensor_msgs::Image*)NULL) +
                                size_at(static_cast<sensor_msgs::Image*>(0));
    ROS_INFO("%zu bytes more", image->data.size() - nothing);
  }
  static std::size_t size_of(const sensor_msgs::ImagePtr& image) { return image ? image->data.size() : 0; }
  static std::size_t size_at(const sensor_msgs::Image* image) { return image ? image->data.size() : 0; }
  ros::Subscriber subscriber_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Node(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Node::on_image, this)) {}
// +  explicit Node(ros::NodeHandle& nh) : subscriber_(tzc::subscribe(nh, "image", 1, &Node::on_image, this)) {}
