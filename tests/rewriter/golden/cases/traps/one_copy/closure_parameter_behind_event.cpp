// Within one call of the closure its parameter is used behind a publish: in the order of the source, and in a loop of the closure.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

void in_order(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_order", 10);
  while (ros::ok()) {
    sensor_msgs::Image image;
    image.data.resize(100, 1);
    std::for_each(image.data.begin(), image.data.end(), [&](uint8_t& x) {
      pub.publish(image);
      x += 3;
    });
  }
}
void in_loop(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("in_loop", 10);
  sensor_msgs::Image image;
  image.data.resize(100, 1);
  std::for_each(image.data.begin(), image.data.end(), [&](uint8_t& x) {
    for (int i = 0; i < 2; ++i) {
      x += 3;
      pub.publish(image);
    }
  });
}
//--- expected
