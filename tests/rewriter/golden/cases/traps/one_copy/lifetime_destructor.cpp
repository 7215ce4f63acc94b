// The destructor of another local writes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Writer {
  explicit Writer(uint8_t* p) : pixels(p) {}
  ~Writer() { *pixels = 1; }
  uint8_t* pixels;
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Writer writer(&image.data[0]);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a member
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
