// The message is the member of a class template, which is given its type elsewhere.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
class Repeater {
 public:
  explicit Repeater(ros::Publisher& pub) : pub_(pub) {}
  M& message() { return message_; }
  void send() { pub_.publish(message_); }

 private:
  ros::Publisher& pub_;
  M message_;
};

class Node {
 public:
  void tick() {
    repeater_.message().data.assign(1000, 1);
    repeater_.send();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  Repeater<sensor_msgs::Image> repeater_{pub_};
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  while (ros::ok()) node.tick();
}
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1005 its type is the parameter 'M' of a class template
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Repeater(ros::Publisher& pub) : pub_(pub) {}
// +  explicit Repeater(tzc::Publisher& pub) : pub_(pub) {}
// -  ros::Publisher& pub_;
// +  tzc::Publisher& pub_;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
