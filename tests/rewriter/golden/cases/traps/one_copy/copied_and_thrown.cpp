// The handler of a thrown array is chosen by its type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  try {
    if (image.data[0] > 2) throw image.data;
  } catch (const std::vector<uint8_t>& refused) {
    image.data.assign(refused.size(), 1);
  }
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used in a way that is not understood
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
