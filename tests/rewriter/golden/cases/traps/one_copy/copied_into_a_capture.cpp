// A copy that a closure holds, whose type is deduced.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <any>
#include <vector>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  const auto kept = [pixels = image.data] { return std::any(pixels); };
  pub.publish(image);
  if (std::any_cast<std::vector<uint8_t>>(kept()).empty()) throw 1;
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a 'std::any'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
