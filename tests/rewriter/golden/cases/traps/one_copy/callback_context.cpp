// A C callback with a context pointer.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

typedef void (*Callback)(void*);
void later(Callback callback, void* context);
void now();

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  later([](void* p) { *static_cast<uint8_t*>(p) = 1; }, &image.data[0]);
  pub.publish(image);
  now();
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'later'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
