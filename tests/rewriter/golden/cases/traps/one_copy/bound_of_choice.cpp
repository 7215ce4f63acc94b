// Which array gets the elements is not known, or what is given them is no array of the message.
//RUN: small=4096
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

struct Filler {
  void operator=(std::vector<float>& values) { values.resize(100000); }
};
void operator<<(std::vector<float>& values, int n) {
  values.resize(n);
}

void run(ros::NodeHandle& nh, bool flag, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
  sensor_msgs::LaserScan chosen;
  (flag ? chosen.ranges : chosen.intensities).resize(n);
  pub.publish(chosen);
  sensor_msgs::LaserScan assigned;
  Filler filler;
  filler = assigned.ranges;
  pub.publish(assigned);
  sensor_msgs::LaserScan shifted;
  shifted.ranges << n;
  pub.publish(shifted);
  sensor_msgs::LaserScan by_member;
  std::vector<float> sensor_msgs::LaserScan::*member = flag ? &sensor_msgs::LaserScan::ranges
                                                            : &sensor_msgs::LaserScan::intensities;
  (by_member.*member).resize(n);
  pub.publish(by_member);
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:17 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1009 ported, it would not compile: no viable overloaded '='
// publish src/node.cpp:24 sensor_msgs/LaserScan one_copy 'scan' TZC1009 ported, it would not compile: invalid operands to binary expression ('::tzc::Array<float>' and 'int')
// publish src/node.cpp:29 sensor_msgs/LaserScan one_copy 'scan' TZC1001 it is used through a pointer to member
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// -  sensor_msgs::LaserScan chosen;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 10);
// +  tzc::sensor_msgs::LaserScan chosen;
// +  pub.allocate(chosen);
