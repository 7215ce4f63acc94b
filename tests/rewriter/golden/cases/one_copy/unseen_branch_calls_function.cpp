// A function whose parameter would change its type is called from code that is not compiled.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static void fill(sensor_msgs::Image& image) { image.data.resize(10); }

#ifdef WITH_TESTS
void test() {
  sensor_msgs::Image other;
  fill(other);
}
#endif

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  fill(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC3007 a preprocessor branch that is not compiled here names 'fill'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
