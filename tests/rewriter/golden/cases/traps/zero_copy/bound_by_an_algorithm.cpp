// No array of the message is mentioned, but a function of the library writes to it as a whole.
#include <algorithm>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(5000);
  pub.publish(image);
  std::vector<sensor_msgs::Image> frames(1);
  frames[0] = image;
  sensor_msgs::Image copy;
  std::copy(frames.begin(), frames.end(), &copy);
  pub.publish(copy);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::vector<sensor_msgs::Image> frames(1);
// +  std::vector<tzc::sensor_msgs::Image> frames(1);
// -  sensor_msgs::Image copy;
// +  tzc::sensor_msgs::Image copy;
// +  pub.allocate(copy);
