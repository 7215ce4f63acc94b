// The memory is as large as the stock message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <new>

/// Never destroyed: other static objects may use it in their destructors.
sensor_msgs::Image& last_image() {
  alignas(16) static unsigned char memory[sizeof(sensor_msgs::Image)];
  static sensor_msgs::Image* image = new (memory) sensor_msgs::Image;
  return *image;
}

class Node {
 public:
  void tick(int n) {
    sensor_msgs::Image& image = last_image();
    image.data.assign(n, 7);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1001 it is made in memory whose size the program has chosen
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
