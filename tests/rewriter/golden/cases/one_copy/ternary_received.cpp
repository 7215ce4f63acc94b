// A choice between a received and an own message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
  }
  void callback(const sensor_msgs::ImageConstPtr& image) {
    sensor_msgs::ImagePtr own = boost::make_shared<sensor_msgs::Image>();
    own->data.resize(10);
    sensor_msgs::ImageConstPtr out = image->width ? image : sensor_msgs::ImageConstPtr(own);
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'out'
// subscribe src/node.cpp:9 sensor_msgs/Image shared 'in'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'out' TZC1004 it comes in through the callback 'callback'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("out", 1);
// -    sub_ = nh_.subscribe("in", 1, &Node::callback, this);
// +    pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "out", 1);
// +    sub_ = tzc::subscribe(nh_, "in", 1, &Node::callback, this);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
