// A pointer that is taken anew in each turn.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(10);
  for (int i = 0; i < 3; ++i) {
    uint8_t* pixels = &image.data[0];
    pixels[0] = i;
    pub.publish(image);
  }
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 line 10 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
