// Const access after the publish, cast to non-const.
#include <algorithm>
#include <iterator>
#include <utility>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  const sensor_msgs::Image& same = image;
  pub.publish(image);
  const_cast<uint8_t*>(same.data.data())[0] = 1;
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data loses its const
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data loses its const
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
