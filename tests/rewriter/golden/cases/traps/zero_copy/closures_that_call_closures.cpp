// Closures that call closures twice: 2^26 calls, and as many graphs if each had one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  int n = 0;
  auto f0 = [&] { ++n; };
  auto f1 = [&] { f0(); f0(); };
  auto f2 = [&] { f1(); f1(); };
  auto f3 = [&] { f2(); f2(); };
  auto f4 = [&] { f3(); f3(); };
  auto f5 = [&] { f4(); f4(); };
  auto f6 = [&] { f5(); f5(); };
  auto f7 = [&] { f6(); f6(); };
  auto f8 = [&] { f7(); f7(); };
  auto f9 = [&] { f8(); f8(); };
  auto f10 = [&] { f9(); f9(); };
  auto f11 = [&] { f10(); f10(); };
  auto f12 = [&] { f11(); f11(); };
  auto f13 = [&] { f12(); f12(); };
  auto f14 = [&] { f13(); f13(); };
  auto f15 = [&] { f14(); f14(); };
  auto f16 = [&] { f15(); f15(); };
  auto f17 = [&] { f16(); f16(); };
  auto f18 = [&] { f17(); f17(); };
  auto f19 = [&] { f18(); f18(); };
  auto f20 = [&] { f19(); f19(); };
  auto f21 = [&] { f20(); f20(); };
  auto f22 = [&] { f21(); f21(); };
  auto f23 = [&] { f22(); f22(); };
  auto f24 = [&] { f23(); f23(); };
  auto f25 = [&] { f24(); f24(); };
  auto f26 = [&] { f25(); f25(); };
  f26();
  image.data.resize(n);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
