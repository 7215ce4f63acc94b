// What is called is one of the function's closures, and nothing shows which: each may write to what was published.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void step(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("object", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::function<void()> change = [&image] { image.data[0] = 1; };
  pub.publish(image);
  change();
  pub.publish(image);
}
void by_another(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_another", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::function<void()> change = [&image] { image.data[0] = 1; };
  const std::function<void()> again = [&] { change(); };
  pub.publish(image);
  again();
  pub.publish(image);
}
void before(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("before", 1);
  sensor_msgs::Image image;
  const std::function<void()> fill = [&image] { image.data.resize(100); };
  fill();
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'object'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'object' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'object'
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'by_another'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'by_another' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'by_another'
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'before'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'before'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("object", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "object", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_another", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_another", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("before", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "before", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
