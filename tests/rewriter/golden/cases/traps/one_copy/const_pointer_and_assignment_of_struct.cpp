// The message is assigned as a part of something while a const pointer leads into it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

struct Frame {
  sensor_msgs::Image image;
  int id = 0;
};

class Node {
 public:
  void step() {
    const Frame& shown = frame_;
    const unsigned char* pixels = &shown.image.data[0];
    frame_ = next_;
    frame_.image.height = pixels[10];
    pub_.publish(frame_.image);
  }
  void step_of_many() {
    const std::vector<sensor_msgs::Image>& shown = images_;
    const unsigned char* pixels = &shown[0].data[0];
    images_ = others_;
    images_[0].height = pixels[10];
    second_pub_.publish(images_[0]);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("second", 1);
  Frame frame_, next_;
  std::vector<sensor_msgs::Image> images_, others_;
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 'pixels' points into its data and is used after its data was written to
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'second' TZC1003 'pixels' points into its data and is used after its data was written to
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:32 sensor_msgs/Image one_copy 'second'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("second", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "second", 1);
