// Macros write the words of the call: its name, its object, or a parenthesis.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define ADVERTISE_IMAGE advertise<sensor_msgs::Image>
#define ADVERTISE advertise
#define NODE nh
#define OPEN (
#define CLOSE )
#define IN_PARENTHESES ("image", 10)
#define OF_IMAGE <sensor_msgs::Image>
#define TOPIC(x) "image"

void run(ros::NodeHandle& nh) {
  ros::Publisher a = nh.ADVERTISE_IMAGE("image", 10);
  ros::Publisher b = nh.ADVERTISE<sensor_msgs::Image>("image", 10);
  ros::Publisher c = NODE.advertise<sensor_msgs::Image>("image", 10);
  ros::Publisher d = nh.advertise<sensor_msgs::Image> OPEN TOPIC(0), 10);
  ros::Publisher e = nh.advertise<sensor_msgs::Image>("image", 10 CLOSE;
  ros::Publisher f = nh.advertise<sensor_msgs::Image> IN_PARENTHESES;
  ros::Publisher g = nh.advertise OF_IMAGE("image", 10);
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:17 sensor_msgs/Image plain 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1006 the advertise call comes from a macro
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher a = nh.ADVERTISE_IMAGE("image", 10);
// -  ros::Publisher b = nh.ADVERTISE<sensor_msgs::Image>("image", 10);
// +  ros::Publisher a = tzc::attached<sensor_msgs::Image>(nh.ADVERTISE_IMAGE("image", 10));
// +  ros::Publisher b = tzc::attached<sensor_msgs::Image>(nh.ADVERTISE<sensor_msgs::Image>("image", 10));
// -  ros::Publisher d = nh.advertise<sensor_msgs::Image> OPEN TOPIC(0), 10);
// -  ros::Publisher e = nh.advertise<sensor_msgs::Image>("image", 10 CLOSE;
// -  ros::Publisher f = nh.advertise<sensor_msgs::Image> IN_PARENTHESES;
// -  ros::Publisher g = nh.advertise OF_IMAGE("image", 10);
// +  ros::Publisher d = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image> OPEN TOPIC(0), 10));
// +  ros::Publisher e = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10 CLOSE);
// +  ros::Publisher f = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image> IN_PARENTHESES);
// +  ros::Publisher g = tzc::attached<sensor_msgs::Image>(nh.advertise OF_IMAGE("image", 10));
