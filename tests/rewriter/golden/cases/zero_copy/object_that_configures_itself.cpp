// The function in front of the call changes something, but no argument reads what the package may change.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = configured().advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle& configured() {
    ready_ = true;
    return nh_;
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  bool ready_ = false;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = configured().advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(configured(), "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
