// A factory gets a reference to the publisher, and there may be none to refer to.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::ImagePtr make() {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(1);
  return image;
}

class Node {
 public:
  explicit Node(bool debug) {
    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 1)));
  }
  void publish() {
    sensor_msgs::ImagePtr image = make();
    if (debug_) debug_->publish(image);
  }

 private:
  ros::NodeHandle nh_;
  boost::shared_ptr<ros::Publisher> debug_;
};
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'debug'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr make() {
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +tzc::sensor_msgs::ImagePtr make() {
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  tzc::allocate(*image);
// -    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 1)));
// +    if (debug) debug_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "debug", 1)));
// -    sensor_msgs::ImagePtr image = make();
// +    tzc::sensor_msgs::ImagePtr image = make();
// -  boost::shared_ptr<ros::Publisher> debug_;
// +  boost::shared_ptr<tzc::Publisher> debug_;
