// Elements are copied, exchanged and erased; nothing points to them afterwards.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>

void swap_bytes(sensor_msgs::Image& image) {
  for (std::size_t i = 0; i + 1 < image.data.size(); i += 2) std::swap(image.data[i], image.data[i + 1]);
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher line_pub = nh.advertise<visualization_msgs::Marker>("line", 10);
  while (ros::ok()) {
    sensor_msgs::Image image;
    visualization_msgs::Marker line;
    image.data.resize(n);
    image.data.erase(image.data.begin(), image.data.begin() + 2);
    swap_bytes(image);
    pub.publish(image);
    line.points.resize(n);
    line.points[0] = line.points[n - 1];
    std::swap(line.points[1], line.points[2]);
    line_pub.publish(line);
  }
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:14 visualization_msgs/Marker zero_copy 'line'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 visualization_msgs/Marker zero_copy 'line'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/visualization_msgs/Marker.h>
// -void swap_bytes(sensor_msgs::Image& image) {
// +void swap_bytes(tzc::sensor_msgs::Image& image) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher line_pub = nh.advertise<visualization_msgs::Marker>("line", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::Publisher line_pub = tzc::advertise<tzc::visualization_msgs::Marker>(nh, "line", 10);
// -    sensor_msgs::Image image;
// -    visualization_msgs::Marker line;
// +    tzc::sensor_msgs::Image image;
// +    pub.allocate(image);
// +    tzc::visualization_msgs::Marker line;
// +    line_pub.allocate(line);
