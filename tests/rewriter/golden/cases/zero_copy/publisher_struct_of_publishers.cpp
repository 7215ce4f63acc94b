// Publishers in a struct of the package.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

struct Outputs {
  ros::Publisher image, text;
};

void run(ros::NodeHandle& nh) {
  Outputs out;
  out.image = nh.advertise<sensor_msgs::Image>("image", 1);
  out.text = nh.advertise<std_msgs::String>("text", 1);
  sensor_msgs::Image image;
  image.data.resize(1);
  out.image.publish(image);
  out.text.publish(std_msgs::String());
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:13 std_msgs/String not_needed 'text'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 std_msgs/String not_needed 'text'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  ros::Publisher image, text;
// +  tzc::Publisher image;
// +  ros::Publisher text;
// -  out.image = nh.advertise<sensor_msgs::Image>("image", 1);
// +  out.image = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  out.image.allocate(image);
