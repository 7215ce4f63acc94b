// An operator of the package that names the publisher may do something each time.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Rotation {
 public:
  explicit Rotation(ros::NodeHandle& nh) {
    pubs_[0] = nh.advertise<sensor_msgs::Image>("left", 1);
    pubs_[1] = nh.advertise<sensor_msgs::Image>("right", 1);
  }
  ros::Publisher& operator*() { return pubs_[next_++ % 2]; }
  ros::Publisher& operator[](int i) { return pubs_[i]; }

 private:
  ros::Publisher pubs_[2];
  unsigned next_ = 0;
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : rotation_(nh) {}
  void send(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    (*rotation_).publish(image);
  }
  void send_left(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    rotation_[0].publish(image);
  }

 private:
  Rotation rotation_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy
// publish src/node.cpp:30 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_[0] = nh.advertise<sensor_msgs::Image>("left", 1);
// -    pubs_[1] = nh.advertise<sensor_msgs::Image>("right", 1);
// +    pubs_[0] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "left", 1);
// +    pubs_[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "right", 1);
// -  ros::Publisher& operator*() { return pubs_[next_++ % 2]; }
// -  ros::Publisher& operator[](int i) { return pubs_[i]; }
// +  tzc::Publisher& operator*() { return pubs_[next_++ % 2]; }
// +  tzc::Publisher& operator[](int i) { return pubs_[i]; }
// -  ros::Publisher pubs_[2];
// +  tzc::Publisher pubs_[2];
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
