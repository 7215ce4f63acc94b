// A copy is not written as an assignment where its initializer would become another text: a pack of arguments, and a cast whose type
// is ported.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

template <class... Args>
void relay(Args&&... args) {
  sensor_msgs::Image out(std::forward<Args>(args)...);
  out.header.frame_id = "relay";
  pub.publish(out);
}
template <class... Args>
void relay_made(Args&&... args) {
  auto out = boost::make_shared<sensor_msgs::Image>(std::forward<Args>(args)...);
  out->header.frame_id = "made";
  pub.publish(out);
}

void take(const sensor_msgs::ImageConstPtr& in) {
  relay(*in);
  relay_made(*in);
  sensor_msgs::Image first = *in;
  first.data[0] = 1;
  sensor_msgs::Image second(static_cast<const sensor_msgs::Image&>(first));
  second.data[0] = 2;
  pub.publish(first);
  pub.publish(second);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  ros::Subscriber sub = nh.subscribe("in", 1, take);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'out' TZC1020 it starts as a copy of another message
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'out' TZC1020 it starts as a copy of another message
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'out' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:34 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:35 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// -  ros::Subscriber sub = nh.subscribe("in", 1, take);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 1, take);
