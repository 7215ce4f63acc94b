// What a function returns that is called through a pointer may be any callback; so may what a library binds of a member.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

typedef void (*Callback)(const sensor_msgs::ImageConstPtr&);

struct Node {
  Callback (*choose)(int);
  boost::function<void(const sensor_msgs::ImageConstPtr&)> kept;
  ros::Subscriber a, b;
};

void run(ros::NodeHandle& nh, Node& node) {
  node.a = nh.subscribe("a", 1, node.choose(5));
  node.b = nh.subscribe<sensor_msgs::Image>("b", 1, std::bind(node.kept, std::placeholders::_1));
}
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image copied 'a' TZC2001 the callback is not known here, and pages that it writes to are copied
// subscribe src/node.cpp:15 sensor_msgs/Image copied 'b' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  node.a = nh.subscribe("a", 1, node.choose(5));
// -  node.b = nh.subscribe<sensor_msgs::Image>("b", 1, std::bind(node.kept, std::placeholders::_1));
// +  node.a = tzc::subscribe(nh, "a", 1, node.choose(5));
// +  node.b = tzc::subscribe<sensor_msgs::Image>(nh, "b", 1, std::bind(node.kept, std::placeholders::_1));
