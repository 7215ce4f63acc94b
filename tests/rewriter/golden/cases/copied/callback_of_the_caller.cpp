// Which function is called back, and what it does to the message, is not known here.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Subscriber by_pointer(ros::NodeHandle& nh, void (*callback)(const sensor_msgs::ImageConstPtr&)) {
  return nh.subscribe("image", 50, callback);
}

class Listener {
 public:
  void listen(ros::NodeHandle& nh) {
    sub_ = nh.subscribe<sensor_msgs::Image, const sensor_msgs::ImageConstPtr&>("image", 50, callback_);
  }

 private:
  boost::function<void(const sensor_msgs::ImageConstPtr&)> callback_;
  ros::Subscriber sub_;
};
//--- expected
// subscribe src/node.cpp:6 sensor_msgs/Image copied 'image' TZC2001 the callback is not known here, and pages that it writes to are copied
// subscribe src/node.cpp:12 sensor_msgs/Image copied 'image' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  return nh.subscribe("image", 50, callback);
// +  return tzc::subscribe(nh, "image", 50, callback);
// -    sub_ = nh.subscribe<sensor_msgs::Image, const sensor_msgs::ImageConstPtr&>("image", 50, callback_);
// +    sub_ = tzc::subscribe<sensor_msgs::Image, const sensor_msgs::ImageConstPtr&>(nh, "image", 50, callback_);
