// A deleter writes through a pointer that escaped: the message ends with it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <memory>

struct Painter {
  uint8_t** pixel;
  void operator()(void*) const { **pixel = 0; }
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    std::shared_ptr<void> painter(nullptr, Painter{&pixel_});
    image.data.resize(100);
    pixel_ = &image.data[0];
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  uint8_t* pixel_ = nullptr;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'pixel_'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
