// The address of an object is that of the message that it begins with.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Frame {
  sensor_msgs::Image image;
  int id = 0;
};

struct Sweep {
  sensor_msgs::LaserScan scan;
  int id = 0;
};

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  Frame frame;
  reinterpret_cast<sensor_msgs::Image*>(&frame)->data.assign(n, 6);
  images.publish(frame.image);
  Sweep sweep;
  ((sensor_msgs::LaserScan&)sweep).ranges.assign(n, 6);
  scans.publish(sweep.scan);
}
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:18 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1001 a message that may be this one is cast from 'Frame *', which does not tell what lies there
// publish src/node.cpp:24 sensor_msgs/LaserScan one_copy 'scan' TZC1001 a message that may be this one is cast from 'Sweep', which does not tell what lies there
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// +  tzc::Publisher images = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// +  tzc::Publisher scans = tzc::advertise<sensor_msgs::LaserScan>(nh, "scan", 10);
