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
