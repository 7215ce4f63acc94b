// What the array consists of keeps the addresses of what it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

struct Pixel {
  Pixel& operator=(uint8_t& element) {
    at = &element;
    return *this;
  }
  uint8_t* at = nullptr;
};

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    Pixel pixels[100];
    std::copy(image.data.begin(), image.data.end(), pixels);
    pub_.publish(image);
    *pixels[0].at = 3;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// publish src/node.cpp:24 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// advertise src/node.cpp:29 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
