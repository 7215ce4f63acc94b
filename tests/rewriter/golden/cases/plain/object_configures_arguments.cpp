// The node handle comes from a function that sets what the arguments read.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = configured().advertise<sensor_msgs::Image>(topic(), queue_); }
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
  ros::Publisher pub_;
  std::string name_;
  int queue_ = 1;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image plain TZC1023 evaluating the node handle may change what the arguments read
// publish src/node.cpp:11 sensor_msgs/Image plain TZC1023 evaluating the node handle may change what the arguments read
