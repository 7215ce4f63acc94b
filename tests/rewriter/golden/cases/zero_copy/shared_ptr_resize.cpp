// A shared message, new and make_shared.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void publish(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10, true);
  sensor_msgs::ImagePtr first(new sensor_msgs::Image);
  first->data.resize(100);
  pub.publish(first);

  sensor_msgs::Image::Ptr second = boost::make_shared<sensor_msgs::Image>();
  second->data.assign(100, 7);
  pub.publish(second);

  boost::shared_ptr<sensor_msgs::Image> third;
  third.reset(new sensor_msgs::Image());
  third->data.push_back(1);
  pub.publish(*third);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10, true);
// -  sensor_msgs::ImagePtr first(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10, true);
// +  tzc::sensor_msgs::ImagePtr first(new tzc::sensor_msgs::Image);
// +  pub.allocate(*first);
// -  sensor_msgs::Image::Ptr second = boost::make_shared<sensor_msgs::Image>();
// +  tzc::sensor_msgs::Image::Ptr second = boost::make_shared<tzc::sensor_msgs::Image>();
// +  pub.allocate(*second);
// -  boost::shared_ptr<sensor_msgs::Image> third;
// -  third.reset(new sensor_msgs::Image());
// +  boost::shared_ptr<tzc::sensor_msgs::Image> third;
// +  third.reset(new tzc::sensor_msgs::Image());
// +  pub.allocate(*third);
