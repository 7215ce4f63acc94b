// A local array of pointers starts with new messages: each is allocated by the name of its element.
#include <array>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void by_array() {
    sensor_msgs::ImagePtr images[2] = {boost::make_shared<sensor_msgs::Image>(),
                                       boost::make_shared<sensor_msgs::Image>()};
    for (int i = 0; i < 2; ++i) {
      images[i]->data.resize(6000);
      array_pub_.publish(images[i]);
    }
  }
  void by_std_array() {
    std::array<sensor_msgs::ImagePtr, 2> images = {sensor_msgs::ImagePtr(new sensor_msgs::Image),
                                                   sensor_msgs::ImagePtr(new sensor_msgs::Image)};
    images[0]->data.resize(6000);
    images[1]->data.resize(6000);
    std_array_pub_.publish(images[0]);
    std_array_pub_.publish(images[1]);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher array_pub_ = nh_.advertise<sensor_msgs::Image>("array", 1);
  ros::Publisher std_array_pub_ = nh_.advertise<sensor_msgs::Image>("std_array", 1);
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'array'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'std_array'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'std_array'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'array'
// advertise src/node.cpp:29 sensor_msgs/Image zero_copy 'std_array'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::ImagePtr images[2] = {boost::make_shared<sensor_msgs::Image>(),
// -                                       boost::make_shared<sensor_msgs::Image>()};
// +    tzc::sensor_msgs::ImagePtr images[2] = {boost::make_shared<tzc::sensor_msgs::Image>(),
// +                                       boost::make_shared<tzc::sensor_msgs::Image>()};
// +    array_pub_.allocate(*images[0]);
// +    array_pub_.allocate(*images[1]);
// -    std::array<sensor_msgs::ImagePtr, 2> images = {sensor_msgs::ImagePtr(new sensor_msgs::Image),
// -                                                   sensor_msgs::ImagePtr(new sensor_msgs::Image)};
// +    std::array<tzc::sensor_msgs::ImagePtr, 2> images = {tzc::sensor_msgs::ImagePtr(new tzc::sensor_msgs::Image),
// +                                                   tzc::sensor_msgs::ImagePtr(new tzc::sensor_msgs::Image)};
// +    std_array_pub_.allocate(*images[0]);
// +    std_array_pub_.allocate(*images[1]);
// -  ros::Publisher array_pub_ = nh_.advertise<sensor_msgs::Image>("array", 1);
// -  ros::Publisher std_array_pub_ = nh_.advertise<sensor_msgs::Image>("std_array", 1);
// +  tzc::Publisher array_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "array", 1);
// +  tzc::Publisher std_array_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "std_array", 1);
