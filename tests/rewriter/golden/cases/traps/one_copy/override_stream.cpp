// A stream writes into a buffer of the package, which publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>
#include <ostream>

class Node;
class Console : public std::streambuf {
 public:
  explicit Console(Node& node) : node_(node) {}

 protected:
  int overflow(int c) override;

 private:
  Node& node_;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() { pub_.publish(image_); }
  void publish() {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    out_ << 1;
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  Console console_{*this};
  std::ostream out_{&console_};
};

int Console::overflow(int c) {
  node_.send();
  return c;
}
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
