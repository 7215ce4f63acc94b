// A temporary that lives as long as a reference writes before the message ends.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    pixel_ = &image.data[0];
    const Painter& painter = Painter{this};
    pub_.publish(image);
  }
  struct Painter {
    Node* node;
    ~Painter() { *node->pixel_ = 0; }
  };

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  uint8_t* pixel_ = nullptr;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'pixel_'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
