// Other code publishes with it, and a part of the call is compiled elsewhere: a parenthesis would be missing there.
#include <other/library.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10,
#ifdef LATCHED
                                                        true);
#else
                                                        false);
#endif
  other::watch(pub);
}
//--- expected
// advertise src/node.cpp:5 sensor_msgs/Image plain 'image' TZC1010 it is passed to 'other::watch', which is not part of the package
