// An algorithm inserts the pointer into a container that nobody knows.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <iterator>

struct Ring {
  using value_type = uint8_t*;
  void push_back(uint8_t* pointer) { first = pointer; }
  uint8_t* first = nullptr;
};

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    Ring rows;
    std::fill_n(std::back_inserter(rows), 1, image.data.data());
    pub_.publish(image);
    *rows.first = 3;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
