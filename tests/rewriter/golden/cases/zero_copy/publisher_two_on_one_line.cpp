// Two publishers declared together; only one is for a data-heavy type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

class Node {
 public:
  Node() {
    image_ = nh_.advertise<sensor_msgs::Image>("image", 1);
    text_ = nh_.advertise<std_msgs::String>("text", 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    image_.publish(image);
    text_.publish(std_msgs::String());
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher image_, text_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:10 std_msgs/String not_needed 'text'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 std_msgs/String not_needed 'text'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -    image_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +    image_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    image_.allocate(image);
// -  ros::Publisher image_, text_;
// +  tzc::Publisher image_;
// +  ros::Publisher text_;
