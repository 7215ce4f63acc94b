// A generic closure gives a function object to a function of the package, which calls it: it writes to what was published.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void call(const std::function<void()>& change, int) {
  change();
}

void step(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  const std::function<void()> change = [&image] { image.data[0] = 1; };
  const auto apply = [&](auto value) { call(change, value); };
  pub.publish(image);
  apply(1);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1022 line 15 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
