// A function of the package takes a pointer to the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void fill(const sensor_msgs::ImagePtr& image) { image->data.resize(10); }
void fill(sensor_msgs::Image* image) { image->data[0] = 1; }

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  fill(image);
  fill(image.get());
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void fill(const sensor_msgs::ImagePtr& image) { image->data.resize(10); }
// -void fill(sensor_msgs::Image* image) { image->data[0] = 1; }
// +void fill(const tzc::sensor_msgs::ImagePtr& image) { image->data.resize(10); }
// +void fill(tzc::sensor_msgs::Image* image) { image->data[0] = 1; }
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
