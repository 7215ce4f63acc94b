// A publisher that is only there when it is wanted: allocate must ask, too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(bool debug) {
    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 1)));
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    if (debug_) debug_->publish(image);
  }
  void leave_early() {
    sensor_msgs::Image image;
    image.data.resize(2);
    if (!debug_) return;
    debug_->publish(image);
  }
  void open_late() {
    sensor_msgs::Image image;
    image.data.resize(3);
    open();
    debug_->publish(image);
  }
  void surely() {
    if (!debug_) return;
    sensor_msgs::Image image;
    image.data.resize(debug_->getNumSubscribers());
    if (!image.data.empty()) debug_->publish(image);
  }

 private:
  void open() { debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("late", 1))); }
  ros::NodeHandle nh_;
  boost::shared_ptr<ros::Publisher> debug_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy
// publish src/node.cpp:19 sensor_msgs/Image zero_copy
// publish src/node.cpp:25 sensor_msgs/Image zero_copy
// publish src/node.cpp:31 sensor_msgs/Image zero_copy
// advertise src/node.cpp:35 sensor_msgs/Image zero_copy 'late'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 1)));
// +    if (debug) debug_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "debug", 1)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (debug_) debug_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (debug_) debug_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (debug_) debug_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    debug_->allocate(image);
// -  void open() { debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("late", 1))); }
// +  void open() { debug_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "late", 1))); }
// -  boost::shared_ptr<ros::Publisher> debug_;
// +  boost::shared_ptr<tzc::Publisher> debug_;
