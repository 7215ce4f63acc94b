// Copies in templates whose type is written there, or is deduced from what they are ported with.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

template <class From, class To>
void assign(const From& from, To& to) {
  to = from;
}
template <class M>
void relay(const M& in) {
  sensor_msgs::Image out = in;
  out.header.frame_id = "relay";
  pub.publish(out);
}

template <class Pixel>
class Node {
 public:
  void take(const sensor_msgs::ImageConstPtr& in) {
    auto out = *in;
    out.data[0] = sizeof(Pixel);
    pub.publish(out);
    auto made = boost::make_shared<sensor_msgs::Image>();
    *made = *in;
    made->data[0] = 1;
    pub.publish(made);
  }
};

void take(const sensor_msgs::ImageConstPtr& in) {
  relay(*in);
  sensor_msgs::Image out;
  assign(*in, out);
  pub.publish(out);
  Node<uint8_t>().take(in);
  Node<uint16_t>().take(in);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  ros::Subscriber sub = nh.subscribe("in", 1, take);
}
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'out'
// publish src/node.cpp:36 sensor_msgs/Image zero_copy 'out'
// advertise src/node.cpp:43 sensor_msgs/Image zero_copy 'out'
// subscribe src/node.cpp:44 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  sensor_msgs::Image out = in;
// +  tzc::sensor_msgs::Image out;
// +  pub.allocate(out);
// +  out = in;
// -    auto out = *in;
// +    tzc::sensor_msgs::Image out;
// +    pub.allocate(out);
// +    out = *in;
// -    auto made = boost::make_shared<sensor_msgs::Image>();
// +    auto made = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub.allocate(*made);
// -  sensor_msgs::Image out;
// +  tzc::sensor_msgs::Image out;
// +  pub.allocate(out);
// -  pub = nh.advertise<sensor_msgs::Image>("out", 1);
// -  ros::Subscriber sub = nh.subscribe("in", 1, take);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 1);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 1, take);
