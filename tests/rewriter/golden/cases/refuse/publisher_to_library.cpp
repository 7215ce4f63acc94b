// The publisher is handed to another package: plain.
#include <other/library.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  other::watch(pub);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//===
// advertise src/node.cpp:5 sensor_msgs/Image plain 'image' TZC1010 it is handed to 'other::watch', which is not part of the package
// publish src/node.cpp:9 sensor_msgs/Image plain 'image' TZC1010 it is handed to 'other::watch', which is not part of the package
