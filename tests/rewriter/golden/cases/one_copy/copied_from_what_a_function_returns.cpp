// The function may make the publisher, or give the pointer another one: allocate stands in front of it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick() {
    sensor_msgs::Image out = prepared();
    out.height++;
    pub_->publish(out);
  }
  void pointed() {
    const auto out = boost::make_shared<sensor_msgs::Image>(prepared());
    out->height++;
    pub_->publish(out);
  }

 private:
  const sensor_msgs::Image& prepared() {
    if (!pub_) pub_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1)));
    return prototype_;
  }

  ros::NodeHandle nh_;
  boost::shared_ptr<ros::Publisher> pub_;
  sensor_msgs::Image prototype_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1019 where it is built was not found
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    const auto out = boost::make_shared<sensor_msgs::Image>(prepared());
// +    const auto out = boost::make_shared<tzc::sensor_msgs::Image>();
// +    tzc::allocate(*out);
// +    *out = prepared();
// -    if (!pub_) pub_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("image", 1)));
// +    if (!pub_) pub_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)));
// -  boost::shared_ptr<ros::Publisher> pub_;
// +  boost::shared_ptr<tzc::Publisher> pub_;
