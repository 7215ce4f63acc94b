// The node handle comes from a function that sets what the arguments read.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    pub_ = configured().advertise<sensor_msgs::Image>(topic(), queue_);
    relay_ = configured().advertise<sensor_msgs::Image>(topic(), queue_);
  }
  void relay(const sensor_msgs::Image& image) { relay_.publish(image); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle& configured() {
    queue_ = 5;
    name_ = "image";
    return nh_;
  }
  std::string topic() { return name_; }

  ros::NodeHandle nh_;
  ros::Publisher pub_, relay_;
  std::string name_;
  int queue_ = 1;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy
// advertise src/node.cpp:9 sensor_msgs/Image one_copy TZC1023 evaluating the node handle may change what the arguments read
// publish src/node.cpp:11 sensor_msgs/Image one_copy TZC1019 no call that gives 'image' a message was found
// publish src/node.cpp:15 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    relay_ = configured().advertise<sensor_msgs::Image>(topic(), queue_);
// +    relay_ = tzc::attached<sensor_msgs::Image>(configured().advertise<sensor_msgs::Image>(topic(), queue_));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
