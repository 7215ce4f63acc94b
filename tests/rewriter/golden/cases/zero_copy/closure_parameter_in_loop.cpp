// A closure's parameter is gone when the closure returns, in each round of the loop around it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud.h>

#include <algorithm>
#include <numeric>
#include <vector>

void each(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("each", 10);
  while (ros::ok()) {
    sensor_msgs::Image image;
    image.data.resize(100, 1);
    std::for_each(image.data.begin(), image.data.end(), [](uint8_t& x) { x += 3; });
    pub.publish(image);
  }
}
void sorted(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("sorted", 10);
  while (ros::ok()) {
    sensor_msgs::PointCloud cloud;
    cloud.points.resize(100);
    std::sort(cloud.points.begin(), cloud.points.end(),
              [](const geometry_msgs::Point& a, const geometry_msgs::Point& b) { return a.x < b.x; });
    pub.publish(cloud);
  }
}
void summed(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("summed", 10);
  while (ros::ok()) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100, 3);
    scan.angle_max = std::accumulate(scan.ranges.begin(), scan.ranges.end(), 0.f,
                                     [](float a, const float& b) { return a + b; });
    pub.publish(scan);
  }
}
void transformed(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("transformed", 10);
  std::vector<double> values(100, 1.5);
  while (ros::ok()) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(100);
    std::transform(values.begin(), values.end(), scan.ranges.begin(), [](const double& v) { return float(v); });
    pub.publish(scan);
  }
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'each'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'each'
// advertise src/node.cpp:21 sensor_msgs/PointCloud zero_copy 'sorted'
// publish src/node.cpp:27 sensor_msgs/PointCloud zero_copy 'sorted'
// advertise src/node.cpp:31 sensor_msgs/LaserScan zero_copy 'summed'
// publish src/node.cpp:37 sensor_msgs/LaserScan zero_copy 'summed'
// advertise src/node.cpp:41 sensor_msgs/LaserScan zero_copy 'transformed'
// publish src/node.cpp:47 sensor_msgs/LaserScan zero_copy 'transformed'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("each", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "each", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub.allocate(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::PointCloud>("sorted", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "sorted", 10);
// -    sensor_msgs::PointCloud cloud;
// +    tzc::sensor_msgs::PointCloud cloud;
// +    pub.allocate(cloud);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("summed", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "summed", 10);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub.allocate(scan);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("transformed", 10);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "transformed", 10);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub.allocate(scan);
