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
