// The function in front of the call only returns the node handle; what the arguments read stays.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = handle().advertise<sensor_msgs::Image>(name_ + "_raw", queue_); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle& handle() { return nh_; }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::string name_;
  int queue_ = 1;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy
// publish src/node.cpp:11 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = handle().advertise<sensor_msgs::Image>(name_ + "_raw", queue_); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(handle(), name_ + "_raw", queue_); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
