// An iterator cannot be asked whether it leads to a publisher: memory is the node's.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <vector>

bool next_frame(sensor_msgs::Image& image) {
  image.data.resize(640 * 480);
  return image.data.size() > 9;
}

void run(std::vector<ros::Publisher>& pubs, ros::NodeHandle& nh) {
  pubs.push_back(nh.advertise<sensor_msgs::Image>("image", 1));
  for (std::vector<ros::Publisher>::iterator it = pubs.begin(); it != pubs.end(); ++it) {
    sensor_msgs::Image image;
    if (!next_frame(image)) continue;
    it->publish(image);
  }
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -bool next_frame(sensor_msgs::Image& image) {
// +bool next_frame(tzc::sensor_msgs::Image& image) {
// -void run(std::vector<ros::Publisher>& pubs, ros::NodeHandle& nh) {
// -  pubs.push_back(nh.advertise<sensor_msgs::Image>("image", 1));
// -  for (std::vector<ros::Publisher>::iterator it = pubs.begin(); it != pubs.end(); ++it) {
// -    sensor_msgs::Image image;
// +void run(std::vector<tzc::Publisher>& pubs, ros::NodeHandle& nh) {
// +  pubs.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1));
// +  for (std::vector<tzc::Publisher>::iterator it = pubs.begin(); it != pubs.end(); ++it) {
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
