// What is exchanged are pointers to elements, not elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

uint8_t* kept = nullptr;

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(n);
  while (ros::ok()) {
    uint8_t* first = &image.data[0];
    std::swap(kept, first);
    pub.publish(image);
    *kept = 7;
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'std::swap'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
