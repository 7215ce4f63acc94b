// A function of the package that is called as one of the C library.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void read(uint8_t* buffer, std::size_t size);
void poll();

class Node {
 public:
  Node() {
    image_.data.resize(100);
    read(&image_.data[0], 100);
  }
  void step() {
    poll();
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'read'
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
