// Casts that keep the array's type, or take another one, are written out: in the port they would be from a tzc::Array.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

void run(ros::NodeHandle& nh) {
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::Image image;
  std::vector<char>& bytes = reinterpret_cast<std::vector<char>&>(image.data);
  bytes.assign(100, 'x');
  images.publish(image);
  sensor_msgs::LaserScan same;
  ((std::vector<float>&)same.ranges).assign(100, 1.5f);
  scans.publish(same);
  sensor_msgs::LaserScan read;
  read.ranges.assign(100, 1.5f);
  for (float range : (const std::vector<float>&)read.ranges) read.angle_max += range;
  scans.publish(read);
  sensor_msgs::LaserScan copied;
  copied.ranges.assign(100, 1.5f);
  copied.angle_max = static_cast<const std::vector<float>&>(copied.ranges).front();
  scans.publish(copied);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:10 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is cast to 'std::vector<char> &', which its array is not in the port
// publish src/node.cpp:17 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is cast to 'std::vector<float> &', which its array is not in the port
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is cast to 'const std::vector<float> &', which its array is not in the port
// publish src/node.cpp:25 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is cast to 'const std::vector<float> &', which its array is not in the port
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// -  ros::Publisher scans = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// +  tzc::Publisher images = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
// +  tzc::Publisher scans = tzc::advertise<sensor_msgs::LaserScan>(nh, "scan", 10);
