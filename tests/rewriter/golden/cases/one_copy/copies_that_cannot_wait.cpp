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
    subs_.push_back(nh_.subscribe("in", 1, &Node::replaced, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::with_comments, this));
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
  // The message that is copied may end here, the new one be seen at once, and the old one stay when copying throws.
  void replaced(const sensor_msgs::LaserScan::ConstPtr& in) {
    kept_ = boost::make_shared<sensor_msgs::LaserScan>(*in);
    pubs_[5].publish(kept_);
    if (in->ranges.empty()) kept_.reset(new sensor_msgs::LaserScan(*kept_));
    const bool wide = (kept_ = boost::make_shared<sensor_msgs::LaserScan>(*kept_))->ranges.size() > 5;
    if (wide) pubs_[5].publish(kept_);
  }
  sensor_msgs::LaserScanPtr returned(const sensor_msgs::LaserScan& in) {
    return kept_ = boost::make_shared<sensor_msgs::LaserScan>(in);
  }
  void with_comments(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScan remark  // of the laser
        = *in;
    pubs_[6].publish(remark);
    sensor_msgs::LaserScan configured =
#ifdef WITH_FILTER
        filtered(*in);
#else
        *in;
#endif
    pubs_[6].publish(configured);
    sensor_msgs::LaserScan::ConstPtr constant = boost::make_shared<sensor_msgs::LaserScan>(*in);
    pubs_[6].publish(constant);
  }

 private:
  sensor_msgs::LaserScanPtr kept_;
  ros::NodeHandle nh_;
  std::vector<ros::Subscriber> subs_;
  std::vector<ros::Publisher> pubs_ = {
      nh_.advertise<sensor_msgs::LaserScan>("0", 1), nh_.advertise<sensor_msgs::LaserScan>("1", 1),
      nh_.advertise<sensor_msgs::LaserScan>("2", 1), nh_.advertise<sensor_msgs::LaserScan>("3", 1),
      nh_.advertise<sensor_msgs::LaserScan>("4", 1), nh_.advertise<sensor_msgs::LaserScan>("5", 1),
      nh_.advertise<sensor_msgs::LaserScan>("6", 1)};
};
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:11 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:12 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:13 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:14 sensor_msgs/LaserScan copied 'in' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:15 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:16 sensor_msgs/LaserScan copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// publish src/node.cpp:20 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'constant'
// publish src/node.cpp:25 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'several'
// publish src/node.cpp:30 sensor_msgs/LaserScan one_copy TZC1006 its type is written by a macro
// publish src/node.cpp:33 sensor_msgs/LaserScan one_copy TZC1020 it starts as a copy of another message
// publish src/node.cpp:37 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'by_value'
// publish src/node.cpp:42 sensor_msgs/LaserScan one_copy TZC1020 it starts as a copy of another message
// publish src/node.cpp:45 sensor_msgs/LaserScan one_copy TZC1020 it starts as a copy of another message
// publish src/node.cpp:53 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'with_comments'
// publish src/node.cpp:60 sensor_msgs/LaserScan one_copy TZC1004 it comes in through the callback 'with_comments'
// publish src/node.cpp:62 sensor_msgs/LaserScan one_copy TZC1020 it starts as a copy of another message
// advertise src/node.cpp:70 sensor_msgs/LaserScan one_copy '0'
// advertise src/node.cpp:70 sensor_msgs/LaserScan one_copy '1'
// advertise src/node.cpp:71 sensor_msgs/LaserScan one_copy '2'
// advertise src/node.cpp:71 sensor_msgs/LaserScan one_copy '3'
// advertise src/node.cpp:72 sensor_msgs/LaserScan one_copy '4'
// advertise src/node.cpp:72 sensor_msgs/LaserScan one_copy '5'
// advertise src/node.cpp:73 sensor_msgs/LaserScan one_copy '6'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::constant, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::several, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::by_macro, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::unnamed, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::by_value, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::replaced, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::with_comments, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::constant, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::several, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::by_macro, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::unnamed, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::by_value, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::replaced, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::with_comments, this));
// -  std::vector<ros::Publisher> pubs_ = {
// -      nh_.advertise<sensor_msgs::LaserScan>("0", 1), nh_.advertise<sensor_msgs::LaserScan>("1", 1),
// -      nh_.advertise<sensor_msgs::LaserScan>("2", 1), nh_.advertise<sensor_msgs::LaserScan>("3", 1),
// -      nh_.advertise<sensor_msgs::LaserScan>("4", 1), nh_.advertise<sensor_msgs::LaserScan>("5", 1),
// -      nh_.advertise<sensor_msgs::LaserScan>("6", 1)};
// +  std::vector<tzc::Publisher> pubs_ = {
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "0", 1), tzc::advertise<sensor_msgs::LaserScan>(nh_, "1", 1),
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "2", 1), tzc::advertise<sensor_msgs::LaserScan>(nh_, "3", 1),
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "4", 1), tzc::advertise<sensor_msgs::LaserScan>(nh_, "5", 1),
// +      tzc::advertise<sensor_msgs::LaserScan>(nh_, "6", 1)};
