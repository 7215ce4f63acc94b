// A subscribe call that a macro makes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define SUBSCRIBE(nh, topic, callback) nh.subscribe(topic, 1, callback)

void callback(const sensor_msgs::ImageConstPtr& image) {}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = SUBSCRIBE(nh, "image", callback);
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image plain 'image' TZC2003 the subscribe call comes from a macro
