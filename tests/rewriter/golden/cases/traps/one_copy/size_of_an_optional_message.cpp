// An optional, a pair and an array have the message in them, and so their sizes change with it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <array>
#include <optional>

struct Frame {
  std::optional<sensor_msgs::Image> image;
  int number = 0;
};
struct Two {
  std::array<sensor_msgs::Image, 2> images;
};

class Node {
 public:
  void tick() {
    Frame frame;
    frame.image.emplace();
    frame.image->data.resize(100);
    frame.image->step = sizeof(Frame);
    pub_.publish(*frame.image);
    Two two;
    two.images[0].data.resize(100);
    two.images[0].step = sizeof(Two);
    pub_.publish(two.images[0]);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for the size of a class that holds it
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for the size of a class that holds it
// advertise src/node.cpp:32 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
