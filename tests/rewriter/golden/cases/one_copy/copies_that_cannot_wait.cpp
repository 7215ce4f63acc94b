// A copy that cannot be written as an assignment, or not where allocate stands.
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#define COPY_OF(name, message) sensor_msgs::LaserScan name = message

class Node {
 public:
  Node() {
    subs_.push_back(nh_.subscribe("in", 1, &Node::constant, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::several, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::by_macro, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::unnamed, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::by_value, this));
  }
  void constant(const sensor_msgs::LaserScan::ConstPtr& in) {
    const sensor_msgs::LaserScan out = *in;
    pubs_[0].publish(out);
  }
  void several(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScan out = *in, other;
    out.ranges[0] = 1;
    pubs_[1].publish(out);
  }
  void by_macro(const sensor_msgs::LaserScan::ConstPtr& in) {
    COPY_OF(out, *in);
    out.ranges[0] = 1;
    pubs_[2].publish(out);
  }
  void unnamed(const sensor_msgs::LaserScan::ConstPtr& in) {
    pubs_[3].publish(boost::make_shared<sensor_msgs::LaserScan>(*in));
  }
  void by_value(sensor_msgs::LaserScan in) {
    in.ranges[0] = 1;
    pubs_[4].publish(in);
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Subscriber> subs_;
  std::vector<ros::Publisher> pubs_ = {
      nh_.advertise<sensor_msgs::LaserScan>("0", 1), nh_.advertise<sensor_msgs::LaserScan>("1", 1),
      nh_.advertise<sensor_msgs::LaserScan>("2", 1), nh_.advertise<sensor_msgs::LaserScan>("3", 1),
      nh_.advertise<sensor_msgs::LaserScan>("4", 1)};
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:11 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:12 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:13 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:14 sensor_msgs/LaserScan copied 'in' TZC2001 the callback may write to the message, so it gets a copy of its own
// publish src/node.cpp:18 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'constant'
// publish src/node.cpp:23 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'several'
// publish src/node.cpp:28 sensor_msgs/LaserScan one_copy TZC1006 its type is written by a macro
// publish src/node.cpp:31 sensor_msgs/LaserScan one_copy TZC1020 it starts as a copy of another message
// publish src/node.cpp:35 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'by_value'
// advertise src/node.cpp:42 sensor_msgs/LaserScan one_copy '0'
// advertise src/node.cpp:42 sensor_msgs/LaserScan one_copy '1'
// advertise src/node.cpp:43 sensor_msgs/LaserScan one_copy '2'
// advertise src/node.cpp:43 sensor_msgs/LaserScan one_copy '3'
// advertise src/node.cpp:44 sensor_msgs/LaserScan one_copy '4'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::constant, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::several, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::by_macro, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::unnamed, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::by_value, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::constant, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::several, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::by_macro, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::unnamed, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::by_value, this));
// -  std::vector<ros::Publisher> pubs_ = {
// -      nh_.advertise<sensor_msgs::LaserScan>("0", 1), nh_.advertise<sensor_msgs::LaserScan>("1", 1),
// -      nh_.advertise<sensor_msgs::LaserScan>("2", 1), nh_.advertise<sensor_msgs::LaserScan>("3", 1),
// -      nh_.advertise<sensor_msgs::LaserScan>("4", 1)};
// +  std::vector<tzc::Publisher> pubs_ = {
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "0", 1), tzc::advertise<sensor_msgs::LaserScan>(nh_, "1", 1),
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "2", 1), tzc::advertise<sensor_msgs::LaserScan>(nh_, "3", 1),
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "4", 1)};
