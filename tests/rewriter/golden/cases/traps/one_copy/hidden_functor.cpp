// A functor of the package, trivially copied, publishes when an algorithm calls it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <algorithm>
#include <vector>

class Node;
struct Sender {
  Node* node;
  void operator()(int) const;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() { pub_.publish(image_); }
  void publish(const std::vector<int>& rows) {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    std::for_each(rows.begin(), rows.end(), Sender{this});
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

void Sender::operator()(int) const {
  node->send();
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
