// A publisher that is never advertised in the package.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(const ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image one_copy TZC1017 nothing that the package advertises is given to the parameter 'pub'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pub.publish(image);
// +  tzc::publish(pub, image);
