// A pointer, or a function's result, that leads to the array itself: the port keeps it, and what it writes later is copied.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

sensor_msgs::LaserScan of_function;
auto& ranges_of() {
  static int count = 0;
  ++count;
  return of_function.ranges;
}
void given(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("pointer", 1);
  for (int k = 0; k < 8; ++k) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(40);
    auto* ranges = &scan.ranges;
    pub.publish(scan);
    (*ranges)[k] = 1;
    pub.publish(scan);
  }
}
void arrow(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("arrow", 1);
  sensor_msgs::LaserScan one, other;
  one.ranges.resize(40);
  other.ranges.resize(40);
  auto* ranges = &one.ranges;
  if (ros::ok()) ranges = &other.ranges;
  pub.publish(one);
  pub.publish(other);
  ranges->push_back(1);
  pub.publish(other);
}
void result(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("result", 1);
  of_function.ranges.resize(40);
  pub.publish(of_function);
  ranges_of()[1] = 1;
  pub.publish(of_function);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/LaserScan zero_copy 'pointer'
// publish src/node.cpp:17 sensor_msgs/LaserScan one_copy 'pointer' TZC1022 line 18 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:19 sensor_msgs/LaserScan zero_copy 'pointer'
// advertise src/node.cpp:23 sensor_msgs/LaserScan zero_copy 'arrow'
// publish src/node.cpp:29 sensor_msgs/LaserScan one_copy 'arrow' TZC1022 line 31 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:30 sensor_msgs/LaserScan one_copy 'arrow' TZC1022 line 31 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:32 sensor_msgs/LaserScan zero_copy 'arrow'
// advertise src/node.cpp:35 sensor_msgs/LaserScan one_copy 'result'
// publish src/node.cpp:37 sensor_msgs/LaserScan one_copy 'result' TZC1003 a pointer into its data is returned
// publish src/node.cpp:39 sensor_msgs/LaserScan one_copy 'result' TZC1003 a pointer into its data is returned
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("pointer", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "pointer", 1);
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub.allocate(scan);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("arrow", 1);
// -  sensor_msgs::LaserScan one, other;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "arrow", 1);
// +  tzc::sensor_msgs::LaserScan one, other;
// +  pub.allocate(one);
// +  pub.allocate(other);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("result", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::LaserScan>(nh, "result", 1);
