// One of two publishers sends the message. It is allocated from the first one: that gives memory also where it is not advertised.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(bool raw) : is_raw_(raw) {
    if (is_raw_)
      raw_ = nh_.advertise<sensor_msgs::Image>("raw", 10);
    else
      rectified_ = nh_.advertise<sensor_msgs::Image>("rectified", 10);
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (is_raw_)
      raw_.publish(image);
    else
      rectified_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher raw_, rectified_;
  bool is_raw_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'raw'
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'rectified'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'raw'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'rectified'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      raw_ = nh_.advertise<sensor_msgs::Image>("raw", 10);
// +      raw_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "raw", 10);
// -      rectified_ = nh_.advertise<sensor_msgs::Image>("rectified", 10);
// +      rectified_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "rectified", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    raw_.allocate(image);
// -  ros::Publisher raw_, rectified_;
// +  tzc::Publisher raw_, rectified_;
