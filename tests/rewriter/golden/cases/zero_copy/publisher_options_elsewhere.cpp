// AdvertiseOptions that come from elsewhere name no type: the publisher stays what it is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, ros::AdvertiseOptions& options) {
  ros::Publisher pub = nh.advertise(options);
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy
// publish src/node.cpp:9 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pub.publish(image);
// +  tzc::publish(pub, image);
