// A deleter of boost::shared_ptr, in a member of another object, publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node;
struct Sender {
  Node* node;
  void operator()(const void*) const;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  struct Held {
    boost::shared_ptr<sensor_msgs::Image> other;
  };
  void arm() { held_.other = boost::shared_ptr<sensor_msgs::Image>(new sensor_msgs::Image, Sender{this}); }
  void send() { pub_.publish(image_); }
  void publish() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    held_ = Held();
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  Held held_;
};

void Sender::operator()(const void*) const {
  node->send();
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
