// A comment whose line ends in a backslash goes on in the next one: what is inserted stands in front of it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>  // images in C:\share\
#define IMAGES 1

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;  // frames go to C:\temp\
  image.height = 5;
  image.data.resize(10);
  pub.publish(image);
  sensor_msgs::Image blank;  // a blank behind it \ 
  blank.height = 5;
  blank.data.resize(10);
  pub.publish(blank);
  sensor_msgs::Image open; /*/
  open.height = 5; */
  open.data.resize(10);
  pub.publish(open);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image image;  // frames go to C:\temp\
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image image; pub.allocate(image);  // frames go to C:\temp\
// -  sensor_msgs::Image blank;  // a blank behind it \ 
// +  tzc::sensor_msgs::Image blank; pub.allocate(blank);  // a blank behind it \ 
// -  sensor_msgs::Image open; /*/
// +  tzc::sensor_msgs::Image open; pub.allocate(open); /*/
