// A received message that is copied, changed and published: the copy that the code makes goes into shared memory.
#include <other/scan_buffer.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

typedef sensor_msgs::LaserScan Scan;

class Node {
 public:
  Node() {
    subs_.push_back(nh_.subscribe("in", 1, &Node::named, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::others, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::pointers, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::assigned, this));
    subs_.push_back(nh_.subscribe("in", 1, &Node::by_reference, this));
    subs_.push_back(nh_.subscribe<sensor_msgs::LaserScan>("in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
      sensor_msgs::LaserScan out = *in;
      out.ranges[0] = 0;
      pub_.publish(out);
    }));
  }

  void named(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScan out = *in;  // with a remark
    out.header.frame_id = "laser";
    for (float& range : out.ranges) range *= 2;
    pub_.publish(out);
  }
  void others(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScan round(*in);
    round.ranges[0] = 1;
    pub_.publish(round);
    sensor_msgs::LaserScan named = sensor_msgs::LaserScan(*in);
    named.ranges[0] = 6;
    pub_.publish(named);
    sensor_msgs::LaserScan braces{*in};
    braces.ranges[0] = 2;
    pub_.publish(braces);
    Scan other_name =
        *in;
    other_name.ranges[0] = 3;
    pub_.publish(other_name);
    auto deduced = *in;
    deduced.ranges[0] = 4;
    pub_.publish(deduced);
    sensor_msgs::LaserScan chosen = in->ranges.size() > 3 ? *in : buffer_.latest();
    chosen.ranges[0] = 5;
    pub_.publish(chosen);
  }
  void pointers(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScanPtr made = boost::make_shared<sensor_msgs::LaserScan>(*in);
    made->ranges[0] = 1;
    pub_.publish(made);
    sensor_msgs::LaserScan::Ptr by_new(new sensor_msgs::LaserScan(*in));
    by_new->ranges[0] = 2;
    pub_.publish(by_new);
    auto deduced = boost::make_shared<sensor_msgs::LaserScan>(*in);
    deduced->ranges[0] = 3;
    pub_.publish(deduced);
  }
  void assigned(const sensor_msgs::LaserScan::ConstPtr& in) {
    sensor_msgs::LaserScan out;
    out = *in;
    out.ranges[0] = 1;
    pub_.publish(out);
    last_ = buffer_.latest();
    last_.ranges[0] = 2;
    pub_.publish(last_);
  }
  void by_reference(const sensor_msgs::LaserScan& in) {
    sensor_msgs::LaserScan out = in;
    out.ranges[0] = 1;
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("out", 1);
  std::vector<ros::Subscriber> subs_;
  other::ScanBuffer buffer_;
  sensor_msgs::LaserScan last_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/LaserScan shared 'in'
// subscribe src/node.cpp:12 sensor_msgs/LaserScan shared 'in'
// subscribe src/node.cpp:13 sensor_msgs/LaserScan shared 'in'
// subscribe src/node.cpp:14 sensor_msgs/LaserScan shared 'in'
// subscribe src/node.cpp:15 sensor_msgs/LaserScan shared 'in'
// subscribe src/node.cpp:16 sensor_msgs/LaserScan shared 'in'
// publish src/node.cpp:19 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:27 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:32 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:35 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:38 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:42 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:45 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:48 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:53 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:56 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:59 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:65 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:68 sensor_msgs/LaserScan zero_copy 'out'
// publish src/node.cpp:73 sensor_msgs/LaserScan zero_copy 'out'
// advertise src/node.cpp:78 sensor_msgs/LaserScan zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::named, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::others, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::pointers, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::assigned, this));
// -    subs_.push_back(nh_.subscribe("in", 1, &Node::by_reference, this));
// -    subs_.push_back(nh_.subscribe<sensor_msgs::LaserScan>("in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
// -      sensor_msgs::LaserScan out = *in;
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::named, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::others, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::pointers, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::assigned, this));
// +    subs_.push_back(tzc::subscribe(nh_, "in", 1, &Node::by_reference, this));
// +    subs_.push_back(tzc::subscribe<sensor_msgs::LaserScan>(nh_, "in", 1, [this](const sensor_msgs::LaserScanConstPtr& in) {
// +      tzc::sensor_msgs::LaserScan out;
// +      pub_.allocate(out);
// +      out = *in;
// -    sensor_msgs::LaserScan out = *in;  // with a remark
// +    tzc::sensor_msgs::LaserScan out;  // with a remark
// +    pub_.allocate(out);
// +    out = *in;
// -    sensor_msgs::LaserScan round(*in);
// +    tzc::sensor_msgs::LaserScan round;
// +    pub_.allocate(round);
// +    round = *in;
// -    sensor_msgs::LaserScan named = sensor_msgs::LaserScan(*in);
// +    tzc::sensor_msgs::LaserScan named;
// +    pub_.allocate(named);
// +    named = *in;
// -    sensor_msgs::LaserScan braces{*in};
// +    tzc::sensor_msgs::LaserScan braces;
// +    pub_.allocate(braces);
// +    braces = *in;
// -    Scan other_name =
// -        *in;
// +    tzc::sensor_msgs::LaserScan other_name;
// +    pub_.allocate(other_name);
// +    other_name = *in;
// -    auto deduced = *in;
// +    tzc::sensor_msgs::LaserScan deduced;
// +    pub_.allocate(deduced);
// +    deduced = *in;
// -    sensor_msgs::LaserScan chosen = in->ranges.size() > 3 ? *in : buffer_.latest();
// +    tzc::sensor_msgs::LaserScan chosen;
// +    tzc::allocate(chosen);
// +    chosen = in->ranges.size() > 3 ? *in : buffer_.latest();
// -    sensor_msgs::LaserScanPtr made = boost::make_shared<sensor_msgs::LaserScan>(*in);
// +    tzc::sensor_msgs::LaserScanPtr made = boost::make_shared<tzc::sensor_msgs::LaserScan>();
// +    pub_.allocate(*made);
// +    *made = *in;
// -    sensor_msgs::LaserScan::Ptr by_new(new sensor_msgs::LaserScan(*in));
// +    tzc::sensor_msgs::LaserScan::Ptr by_new(new tzc::sensor_msgs::LaserScan());
// +    pub_.allocate(*by_new);
// +    *by_new = *in;
// -    auto deduced = boost::make_shared<sensor_msgs::LaserScan>(*in);
// +    auto deduced = boost::make_shared<tzc::sensor_msgs::LaserScan>();
// +    pub_.allocate(*deduced);
// +    *deduced = *in;
// -    sensor_msgs::LaserScan out;
// +    tzc::sensor_msgs::LaserScan out;
// +    pub_.allocate(out);
// -    sensor_msgs::LaserScan out = in;
// +    tzc::sensor_msgs::LaserScan out;
// +    pub_.allocate(out);
// +    out = in;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::LaserScan>("out", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "out", 1);
// -  sensor_msgs::LaserScan last_;
// +  tzc::sensor_msgs::LaserScan last_;
