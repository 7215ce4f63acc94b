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
