// A stream's buffer lies in the message's elements: what is written to the stream behind the publish is written to them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <ostream>
#include <strstream>

std::ostream out(nullptr);

void by_name(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_name", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  char* text = reinterpret_cast<char*>(image.data.data());
  out.rdbuf(new std::strstreambuf(text, 100, text));
  pub.publish(image);
  out << "late";
}
void by_reference(ros::NodeHandle& nh, std::ostream& log) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_reference", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  char* text = reinterpret_cast<char*>(image.data.data());
  log.rdbuf(new std::strstreambuf(text, 100, text));
  pub.publish(image);
  log << "late" << 1 << std::endl;
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'by_name'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'by_name' TZC1003 a pointer into its data is kept in a 'std::strstreambuf'
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'by_reference'
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'by_reference' TZC1003 a pointer into its data is kept in a 'std::strstreambuf'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_name", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_name", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_reference", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_reference", 10);
