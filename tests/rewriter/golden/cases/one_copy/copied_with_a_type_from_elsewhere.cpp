// A copy whose type is said by what it is made of: a parameter of a function template, decltype. It is of that type whatever is
// written there, so it cannot be ported without its original.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;
sensor_msgs::Image last;

template <class M>
void relay(const M& in) {
  M out = in;
  out.header.frame_id = "relay";
  pub.publish(out);
}
template <class M>
void relay_assigned(const M& in) {
  M out;
  out = in;
  out.data.push_back(2);
  pub.publish(out);
}
template <class M>
void relay_pointer(const boost::shared_ptr<M const>& in) {
  boost::shared_ptr<M> out(new M(*in));
  out->header.frame_id = "pointer";
  pub.publish(out);
}
template <class M>
void relay_made(const M& in) {
  auto out = boost::make_shared<M>();
  *out = in;
  pub.publish(out);
}
// Named, the type would be that of one instance, and the function would take no other message any more.
template <class P>
void relay_auto(const P& in) {
  auto out = *in;
  out.header.frame_id = "auto";
  pub.publish(out);
}
template <class M>
void assign(const M& from, M& to) {
  to = from;
}
template <class M>
M changed(const M& in) {
  M out = in;
  out.data.push_back(1);
  return out;
}

void take(const sensor_msgs::ImageConstPtr& in) {
  relay(*in);
  relay_assigned(*in);
  relay_pointer(in);
  relay_made(*in);
  relay_auto(in);
  sensor_msgs::Image assigned;
  assign(*in, assigned);
  pub.publish(assigned);
  auto made = changed(*in);
  pub.publish(made);
  last = *in;
  decltype(last) same = last;
  same.data.push_back(2);
  pub.publish(same);
}
void take_type(const sensor_msgs::ImageConstPtr& in) {
  std::decay_t<decltype(*in)> out = *in;
  out.data.push_back(1);
  pub.publish(out);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  ros::Subscriber first = nh.subscribe("in", 1, take);
  ros::Subscriber second = nh.subscribe("in", 1, take_type);
}
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:39 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:60 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:62 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'take'
// publish src/node.cpp:66 sensor_msgs/Image one_copy 'out' TZC1001 the program asks for its type
// publish src/node.cpp:71 sensor_msgs/Image one_copy 'out' TZC1001 the program asks for its type
// advertise src/node.cpp:76 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:77 sensor_msgs/Image shared 'in'
// subscribe src/node.cpp:78 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// -  ros::Subscriber first = nh.subscribe("in", 1, take);
// -  ros::Subscriber second = nh.subscribe("in", 1, take_type);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "out", 1);
// +  ros::Subscriber first = tzc::subscribe(nh, "in", 1, take);
// +  ros::Subscriber second = tzc::subscribe(nh, "in", 1, take_type);
