// What a function object or an override of a library's class builds may come from the package's own code: nothing shows it.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

sensor_msgs::ImagePtr make(int size) {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(size);
  return image;
}

struct Makers {
  std::vector<std::function<sensor_msgs::ImagePtr(int)>> functions;
  sensor_msgs::Image (*pointer)(int);
};

void run(ros::NodeHandle& nh, Makers& makers) {
  makers.functions.push_back(make);
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  pub.publish(makers.functions[0](10));
  sensor_msgs::Image image = makers.pointer(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC1013 a function that is known only when it runs builds the message
// publish src/node.cpp:24 sensor_msgs/Image one_copy 'image' TZC1013 it starts as 'makers.pointer(10)', which a function that is known only when it runs builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
