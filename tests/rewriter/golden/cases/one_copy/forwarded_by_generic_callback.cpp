// A callback that takes the message as `const auto&` gets a received message, as one with a written type does.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

int main() {
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
  ros::Publisher kept = nh.advertise<sensor_msgs::Image>("kept", 5);
  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) { pub.publish(in); });
  ros::Subscriber second = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) {
    std::function<sensor_msgs::Image()> get = [in] { return *in; };
    sensor_msgs::Image copy = get();
    kept.publish(copy);
  });
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'out'
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'kept'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'in'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'lambda'
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'in'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'kept' TZC1013 it starts as 'get()', which a function that is known only when it runs builds
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
// -  ros::Publisher kept = nh.advertise<sensor_msgs::Image>("kept", 5);
// -  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) { pub.publish(in); });
// -  ros::Subscriber second = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) {
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 5);
// +  tzc::Publisher kept = tzc::advertise<sensor_msgs::Image>(nh, "kept", 5);
// +  ros::Subscriber sub = tzc::subscribe<sensor_msgs::Image>(nh, "in", 5, [&](const auto& in) { pub.publish(in); });
// +  ros::Subscriber second = tzc::subscribe<sensor_msgs::Image>(nh, "in", 5, [&](const auto& in) {
