// A thread that is joined at the end.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>

struct Joiner {
  std::thread thread;
  ~Joiner() { thread.join(); }
};

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Joiner joiner{std::thread([](uint8_t* p) { *p = 1; }, &image.data[0])};
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in a 'std::thread'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
