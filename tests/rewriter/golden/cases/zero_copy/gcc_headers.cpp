// What GCC's own headers offer and Clang's do not.
#include <omp.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::Publisher& pub, nullptr_t) {
  sensor_msgs::Image image;
  image.data.resize(omp_get_max_threads());
  pub.publish(image);
}
//--- expected
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
