// An assignment releases what a shared pointer held: its deleter publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>

class Node;
struct Sender {
  Node* node;
  void operator()(const void*) const;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void arm() { guard_ = std::shared_ptr<void>(nullptr, Sender{this}); }
  void send() { pub_.publish(image_); }
  void publish() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    guard_ = nullptr;
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::shared_ptr<void> guard_;
};

void Sender::operator()(const void*) const {
  node->send();
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
