// The publisher comes from another package, and stays what it is.
#include <other/library.h>

void run() {
  ros::Publisher pub = other::connect();
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image one_copy TZC1017 it starts as 'other::connect()', which code outside the package builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  pub.publish(image);
// +  tzc::publish(pub, image);
