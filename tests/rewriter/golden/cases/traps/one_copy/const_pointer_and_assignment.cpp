// The message is assigned while a const pointer leads into it: a vector with room keeps its elements in place.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void step() {
    const sensor_msgs::Image& shown = image_;
    const unsigned char* pixels = &shown.data[0];
    image_ = next_;
    next_.data.assign(100, pixels[10]);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_, next_;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 'pixels' points into its data and is used after its data was written to
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
