// --except the topic of a publisher that keeps its class: nothing is attached to it.
//RUN: except=image
#include <other/library.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  other::watch(pub);
  sensor_msgs::Image image;
  image.data.resize(640 * 480);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image plain 'image' TZC1016 left out by --only or --except
// publish src/node.cpp:10 sensor_msgs/Image plain 'image' TZC1016 left out by --only or --except
