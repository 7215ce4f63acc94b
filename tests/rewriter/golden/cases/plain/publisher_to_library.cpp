// The publisher is passed to another package: plain.
#include <other/library.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  other::watch(pub);
  sensor_msgs::Image image;
  image.data.resize(10);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image plain 'image' TZC1010 it is passed to 'other::watch', which is not part of the package
// publish src/node.cpp:9 sensor_msgs/Image plain 'image' TZC1010 it is passed to 'other::watch', which is not part of the package
