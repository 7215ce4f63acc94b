// A weak function that the message does not reach.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

__attribute__((weak)) int rows() {
  return 480;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  while (ros::ok()) {
    const int n = rows();
    sensor_msgs::Image image;
    image.data.resize(n * 640);
    pub.publish(image);
  }
}
//--- expected
