// A local publisher in main.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1000);
  while (ros::ok()) {
    sensor_msgs::Image image;
    image.data.resize(100);
    pub.publish(image);
  }
  return 0;
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1000);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1000);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub.allocate(image);
