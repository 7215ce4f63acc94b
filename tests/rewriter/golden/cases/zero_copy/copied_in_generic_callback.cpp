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
