// std::make_unique runs a constructor of the package, which publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>

class Node;
extern Node* the_node;
void announce();

struct First {
  explicit First(int) { announce(); }
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() { pub_.publish(image_); }
  void publish() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    std::make_unique<First>(1).release();
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

Node* the_node = nullptr;
void announce() {
  the_node->send();
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
