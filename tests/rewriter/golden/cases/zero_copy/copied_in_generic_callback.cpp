// The ways to copy a message in a callback that takes it as `const auto&`.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

int main() {
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) {
    auto first = boost::make_shared<sensor_msgs::Image>(*in);
    first->header.frame_id = "1";
    pub.publish(first);
    sensor_msgs::Image second = *in;
    second.header.frame_id = "2";
    pub.publish(second);
    auto third = *in;
    third.header.frame_id = "3";
    pub.publish(third);
    sensor_msgs::Image fourth(*in);
    fourth.header.frame_id = "4";
    pub.publish(fourth);
    sensor_msgs::Image fifth;
    fifth = *in;
    pub.publish(fifth);
    sensor_msgs::Image sixth{*in};
    sixth.header.frame_id = "6";
    pub.publish(sixth);
  });
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'out'
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'in'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("out", 5);
// -  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("in", 5, [&](const auto& in) {
// -    auto first = boost::make_shared<sensor_msgs::Image>(*in);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 5);
// +  ros::Subscriber sub = tzc::subscribe<sensor_msgs::Image>(nh, "in", 5, [&](const auto& in) {
// +    auto first = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub.allocate(*first);
// +    *first = *in;
// -    sensor_msgs::Image second = *in;
// +    tzc::sensor_msgs::Image second;
// +    pub.allocate(second);
// +    second = *in;
// -    auto third = *in;
// +    tzc::sensor_msgs::Image third;
// +    pub.allocate(third);
// +    third = *in;
// -    sensor_msgs::Image fourth(*in);
// +    tzc::sensor_msgs::Image fourth;
// +    pub.allocate(fourth);
// +    fourth = *in;
// -    sensor_msgs::Image fifth;
// +    tzc::sensor_msgs::Image fifth;
// +    pub.allocate(fifth);
// -    sensor_msgs::Image sixth{*in};
// +    tzc::sensor_msgs::Image sixth;
// +    pub.allocate(sixth);
// +    sixth = *in;
