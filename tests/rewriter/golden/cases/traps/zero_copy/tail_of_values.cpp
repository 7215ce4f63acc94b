// What follows the publish writes to the object's own members and ends temporaries of the standard library.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Pixel {
  uint8_t& value;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    Pixel first{image.data[0]};
    first.value = 1;
    pub_.publish(image);
    ++state_.count;
    state_.name = std::string("sent");
  }

 private:
  struct State {
    int count = 0;
    std::string name;
  };
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  State state_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
