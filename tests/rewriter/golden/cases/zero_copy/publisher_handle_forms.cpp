// Advertised through a pointer, a smart pointer, a temporary, several lines.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle* nh, boost::shared_ptr<ros::NodeHandle> shared) {
  ros::Publisher a = nh->advertise<sensor_msgs::Image>("a", 1);
  ros::Publisher b = shared->advertise<sensor_msgs::Image>("b", 1);
  ros::Publisher c = ros::NodeHandle("~").advertise<sensor_msgs::Image>("c", 1);
  ros::Publisher d =
      (*nh).advertise<sensor_msgs::Image>(  // the topic
          "d",
          1);
  sensor_msgs::Image image;
  image.data.resize(1);
  a.publish(image);
  b.publish(image);
  c.publish(image);
  d.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'b'
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'c'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'd'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'c'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'd'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher a = nh->advertise<sensor_msgs::Image>("a", 1);
// -  ros::Publisher b = shared->advertise<sensor_msgs::Image>("b", 1);
// -  ros::Publisher c = ros::NodeHandle("~").advertise<sensor_msgs::Image>("c", 1);
// -  ros::Publisher d =
// -      (*nh).advertise<sensor_msgs::Image>(  // the topic
// +  tzc::Publisher a = tzc::advertise<tzc::sensor_msgs::Image>(*nh, "a", 1);
// +  tzc::Publisher b = tzc::advertise<tzc::sensor_msgs::Image>(*shared, "b", 1);
// +  tzc::Publisher c = tzc::advertise<tzc::sensor_msgs::Image>(ros::NodeHandle("~"), "c", 1);
// +  tzc::Publisher d =
// +      tzc::advertise<tzc::sensor_msgs::Image>((*nh),  // the topic
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  a.allocate(image);
