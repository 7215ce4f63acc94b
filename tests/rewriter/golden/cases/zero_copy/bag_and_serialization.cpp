// Templates of ROS that read any message read a twin as well.
#include <ros/ros.h>
#include <ros/serialization.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, rosbag::Bag& bag, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(n);
  pub.publish(image);
  bag.write("image", ros::Time(), image);
  bag.write("image", ros::Time(), *image);
  std::vector<uint8_t> buffer(ros::serialization::serializationLength(*image));
  ros::serialization::OStream stream(buffer.data(), buffer.size());
  ros::serialization::serialize(stream, *image);
  if (ros::message_traits::md5sum(*image)) return;
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
