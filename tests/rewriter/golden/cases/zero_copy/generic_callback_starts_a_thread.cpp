// A generic callback makes an object with parentheses whose arguments depend on its own parameter.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("input", 10, [&](const auto& in) {
    std::thread worker([in, &pub]() {
      sensor_msgs::Image copy = *in;
      pub.publish(copy);
    });
    worker.join();
  });
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'input'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("input", 10, [&](const auto& in) {
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  ros::Subscriber sub = tzc::subscribe<sensor_msgs::Image>(nh, "input", 10, [&](const auto& in) {
// -      sensor_msgs::Image copy = *in;
// +      tzc::sensor_msgs::Image copy;
// +      pub.allocate(copy);
// +      copy = *in;
