// What escaped in one turn writes in the next.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void library(uint8_t* pixels);

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  for (int i = 0; i < 3; ++i) {
    library(&image.data[0]);
    pub.publish(image);
  }
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'library'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
