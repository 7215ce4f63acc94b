// A few messages in a local array: each element gets allocate behind the declaration.
#include <array>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void by_array() {
    sensor_msgs::Image images[2];
    for (int i = 0; i < 2; ++i) {
      images[i].data.resize(6000);
      array_pub_.publish(images[i]);
    }
  }
  void by_std_array() {
    std::array<sensor_msgs::Image, 3> images;
    for (sensor_msgs::Image& image : images) image.data.resize(6000);
    for (sensor_msgs::Image& image : images) std_array_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher array_pub_ = nh_.advertise<sensor_msgs::Image>("array", 1);
  ros::Publisher std_array_pub_ = nh_.advertise<sensor_msgs::Image>("std_array", 1);
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'array'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'std_array'
// advertise src/node.cpp:24 sensor_msgs/Image zero_copy 'array'
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'std_array'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image images[2];
// +    tzc::sensor_msgs::Image images[2];
// +    array_pub_.allocate(images[0]);
// +    array_pub_.allocate(images[1]);
// -    std::array<sensor_msgs::Image, 3> images;
// -    for (sensor_msgs::Image& image : images) image.data.resize(6000);
// -    for (sensor_msgs::Image& image : images) std_array_pub_.publish(image);
// +    std::array<tzc::sensor_msgs::Image, 3> images;
// +    std_array_pub_.allocate(images[0]);
// +    std_array_pub_.allocate(images[1]);
// +    std_array_pub_.allocate(images[2]);
// +    for (tzc::sensor_msgs::Image& image : images) image.data.resize(6000);
// +    for (tzc::sensor_msgs::Image& image : images) std_array_pub_.publish(image);
// -  ros::Publisher array_pub_ = nh_.advertise<sensor_msgs::Image>("array", 1);
// -  ros::Publisher std_array_pub_ = nh_.advertise<sensor_msgs::Image>("std_array", 1);
// +  tzc::Publisher array_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "array", 1);
// +  tzc::Publisher std_array_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "std_array", 1);
