// Macros write the words of a subscribe call, or more than its first argument.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define SUBSCRIBE subscribe
#define NODE nh
#define ARGUMENTS "image", 1, callback
#define TOPIC_AND_QUEUE "image", 1
#define CLOSE )

void callback(const sensor_msgs::ImageConstPtr& image) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.SUBSCRIBE("image", 1, callback);
  ros::Subscriber b = NODE.subscribe("image", 1, callback);
  ros::Subscriber c = nh.subscribe(ARGUMENTS);
  ros::Subscriber d = nh.subscribe(TOPIC_AND_QUEUE, callback);
  ros::Subscriber e = nh.subscribe("image", 1, callback CLOSE;
}
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain 'image' TZC2003 the subscribe call comes from a macro
// subscribe src/node.cpp:15 sensor_msgs/Image plain 'image' TZC2003 the subscribe call comes from a macro
// subscribe src/node.cpp:16 sensor_msgs/Image plain 'image' TZC2003 a macro reaches across the arguments
// subscribe src/node.cpp:17 sensor_msgs/Image plain 'image' TZC2003 a macro reaches across the arguments
// subscribe src/node.cpp:18 sensor_msgs/Image plain 'image' TZC2003 the subscribe call comes from a macro
