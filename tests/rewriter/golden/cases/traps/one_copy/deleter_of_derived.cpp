// A shared pointer to a class of a library deletes an object of the package, whose destructor publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>
#include <ios>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void arm() { guard_ = std::shared_ptr<std::ios_base::Init>(new Last(*this)); }
  void publish() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    guard_.reset();
    *first = 1;
  }
  struct Last : std::ios_base::Init {
    explicit Last(Node& node) : node(node) {}
    ~Last() { node.pub_.publish(node.image_); }
    Node& node;
  };

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::shared_ptr<std::ios_base::Init> guard_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
