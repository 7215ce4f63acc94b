// The port of a copy moves its initializer, and the port of another message changes a call in it: they share that text.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

void take(const sensor_msgs::ImageConstPtr& in) {
  cv_bridge::CvImage frame;
  sensor_msgs::Image filled;
  sensor_msgs::Image copy = (frame.toImageMsg(filled), *in);
  pub.publish(filled);
  pub.publish(copy);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  ros::Subscriber sub = nh.subscribe("in", 1, take);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'out' TZC1007 its port would change text that another one's changes otherwise
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'out' TZC1007 its port would change text that another one's changes otherwise
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:19 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// -  ros::Subscriber sub = nh.subscribe("in", 1, take);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 1, take);
