// A value where a list belongs.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace camera {
void read_frame(uint8_t* to);
}

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() {
    image_.data.resize(100);
    camera::read_frame(&image_.data[0]);
    pub_.publish(image_);
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- .tzc-rewrite.yaml
keeps_nothing: camera::read_frame
//--- expected
// error not a sequence
