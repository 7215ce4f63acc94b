// GCC ignores alignas behind a class, with a warning; with Eigen 3.4 that is what point types end in that were written for an older one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define ALIGN16 alignas(16)

struct Point {
  float x, y, z;
} ALIGN16;

// More than the errors behind which Clang gives up, if it may.
struct A { float x; } ALIGN16;
struct B { float x; } ALIGN16;
struct C { float x; } ALIGN16;
struct D { float x; } ALIGN16;
struct E { float x; } ALIGN16;
struct F { float x; } ALIGN16;
struct G { float x; } ALIGN16;
struct H { float x; } ALIGN16;
struct I { float x; } ALIGN16;
struct J { float x; } ALIGN16;
struct K { float x; } ALIGN16;

enum Kind { near, far } alignas(8);

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.resize(100 * sizeof(Point));
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
