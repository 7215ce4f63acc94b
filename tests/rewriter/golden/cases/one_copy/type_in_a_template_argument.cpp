// The call says the type of the message that the function template makes, so that is a stock one, for which allocate does nothing.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

template <class M>
void make(int size) {
  M out;
  out.data.resize(size);
  pub.publish(out);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  make<sensor_msgs::Image>(100);
}
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'out' TZC1009 ported, allocate() would do nothing for a 'sensor_msgs::Image_', which stays a stock message
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
