// A message to all and to one late subscriber.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, boost::bind(&Node::connected, this, _1)); }
  void connected(const ros::SingleSubscriberPublisher& one) { one.publish(map_); }
  void publish() {
    map_.data.resize(10);
    pub_.publish(map_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image map_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'map'
// publish src/node.cpp:8 sensor_msgs/Image plain TZC1014 the message is sent to one subscriber only
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'map'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("map", 1, boost::bind(&Node::connected, this, _1)); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "map", 1, boost::bind(&Node::connected, this, _1)); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image map_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image map_;
