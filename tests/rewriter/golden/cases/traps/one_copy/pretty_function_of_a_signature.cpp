// The text has the types of the parameters, and is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void send(ros::Publisher& pub, sensor_msgs::Image& image) {
  image.data.resize(100);
  image.encoding = __PRETTY_FUNCTION__;
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image;
  send(pub, image);
}
//--- expected
