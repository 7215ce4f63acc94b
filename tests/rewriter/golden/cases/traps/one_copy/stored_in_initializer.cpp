// In a member, by a constructor initializer of another class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Writer {
 public:
  explicit Writer(uint8_t* to) : to_(to) {}
  void write() { *to_ = 1; }

 private:
  uint8_t* to_;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    image_.data.resize(100);
    Writer writer(&image_.data[0]);
    pub_.publish(image_);
    writer.write();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a member
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
