// A function returns a struct that holds it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Row {
  uint8_t *begin, *end;
};
Row row_of(sensor_msgs::Image& image, int i) {
  uint8_t* begin = &image.data[10 * i];
  return {begin, begin + 10};
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Row row = row_of(image, 0);
  pub.publish(image);
  row.begin[0] = 1;
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes part of an aggregate
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
