// A macro writes more than one argument, a comma behind one, or the end of one and more: nothing can stand behind an argument.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define ARGUMENTS "image", 10
#define BOTH(topic, queue) topic, queue
#define WITH_COMMA "image",
#define AND_LATCH 10, true
#define BEGINS "image", 10 +
#define COMMA_QUEUE , 10
#define SAME(x) x

void run(ros::NodeHandle& nh) {
  ros::Publisher a = nh.advertise<sensor_msgs::Image>(ARGUMENTS);
  ros::Publisher b = nh.advertise<sensor_msgs::Image>(BOTH("image", 10));
  ros::Publisher c = nh.advertise<sensor_msgs::Image>(WITH_COMMA 10);
  ros::Publisher d = nh.advertise<sensor_msgs::Image>("image", AND_LATCH);
  ros::Publisher e = nh.advertise<sensor_msgs::Image>(BEGINS 10);
  ros::Publisher f = nh.advertise<sensor_msgs::Image>("image" COMMA_QUEUE);
  ros::Publisher g = nh.advertise<sensor_msgs::Image>(SAME(ARGUMENTS));
  ros::Publisher h = nh.advertise<sensor_msgs::Image>(ARGUMENTS, true);
}
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1006 a macro reaches across the arguments
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher a = nh.advertise<sensor_msgs::Image>(ARGUMENTS);
// -  ros::Publisher b = nh.advertise<sensor_msgs::Image>(BOTH("image", 10));
// -  ros::Publisher c = nh.advertise<sensor_msgs::Image>(WITH_COMMA 10);
// -  ros::Publisher d = nh.advertise<sensor_msgs::Image>("image", AND_LATCH);
// -  ros::Publisher e = nh.advertise<sensor_msgs::Image>(BEGINS 10);
// -  ros::Publisher f = nh.advertise<sensor_msgs::Image>("image" COMMA_QUEUE);
// -  ros::Publisher g = nh.advertise<sensor_msgs::Image>(SAME(ARGUMENTS));
// -  ros::Publisher h = nh.advertise<sensor_msgs::Image>(ARGUMENTS, true);
// +  ros::Publisher a = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(ARGUMENTS));
// +  ros::Publisher b = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(BOTH("image", 10)));
// +  ros::Publisher c = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(WITH_COMMA 10));
// +  ros::Publisher d = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", AND_LATCH));
// +  ros::Publisher e = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(BEGINS 10));
// +  ros::Publisher f = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image" COMMA_QUEUE));
// +  ros::Publisher g = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(SAME(ARGUMENTS)));
// +  ros::Publisher h = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>(ARGUMENTS, true));
