// A function object calls the function as it is: no cast of its pointer.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void writes(const sensor_msgs::ImagePtr& image) {
  image->data.resize(5);
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image, const sensor_msgs::ImagePtr&>(
      "image", 1, boost::function<void(const sensor_msgs::ImagePtr&)>(writes));
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image copied 'image' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image, const sensor_msgs::ImagePtr&>(
// +  ros::Subscriber sub = tzc::subscribe<sensor_msgs::Image, const sensor_msgs::ImagePtr&>(nh,
