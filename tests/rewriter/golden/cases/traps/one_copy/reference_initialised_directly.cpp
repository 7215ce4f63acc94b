// With Clang, a reference to a const std::vector that is initialised directly binds to a copy of the ported array.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

#define FLOATS std::vector<float>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan several;
  several.ranges.assign(100, 1.5f);
  const std::vector<float>&ranges(several.ranges), &intensities(several.intensities);
  several.ranges[3] = 7;
  several.angle_max = ranges[3] + intensities.size();
  pub.publish(several);
  sensor_msgs::LaserScan from_macro;
  from_macro.ranges.assign(100, 1.5f);
  const FLOATS& same(from_macro.ranges);
  from_macro.ranges[3] = 7;
  from_macro.angle_max = same[3];
  pub.publish(from_macro);
  sensor_msgs::LaserScan by_name;
  by_name.ranges.assign(100, 1.5f);
  const std::vector<float>& first = by_name.ranges;
  const std::vector<float>& second(first);
  by_name.ranges[3] = 7;
  by_name.angle_max = second[3];
  pub.publish(by_name);
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:16 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is bound to 'ranges', a reference to a std::vector
// publish src/node.cpp:22 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is bound to 'same', a reference to a std::vector
// publish src/node.cpp:29 sensor_msgs/LaserScan one_copy 'scan' TZC1003 a pointer into its data is bound to 'second', a reference to a std::vector
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::LaserScan>(nh, "scan", 10);
