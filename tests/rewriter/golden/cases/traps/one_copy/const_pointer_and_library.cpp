// A function of a library fills the message while a const pointer leads into it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/fill_image.h>

class Node {
 public:
  void step(const unsigned char* grabbed) {
    const sensor_msgs::Image& shown = image_;
    const unsigned char* pixels = shown.data.data();
    sensor_msgs::fillImage(image_, "mono8", 10, 10, 10, grabbed);
    image_.header.seq = pixels[10];
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 'pixels' points into its data and is used after its data was written to
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
