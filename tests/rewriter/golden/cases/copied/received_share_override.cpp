// The callback is a virtual function, and what overrides it draws.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Base {
 public:
  Base() { sub_ = nh_.subscribe("image", 1, &Base::callback, this); }
  virtual ~Base() = default;
  virtual void callback(const sensor_msgs::ImageConstPtr& image) = 0;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber sub_;
};

class Node : public Base {
 public:
  void callback(const sensor_msgs::ImageConstPtr& image) override {
    cv::Mat mat = cv_bridge::toCvShare(image)->image;
    cv::circle(mat, 1);
  }
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Base() { sub_ = nh_.subscribe("image", 1, &Base::callback, this); }
// +  Base() { sub_ = tzc::subscribe(nh_, "image", 1, &Base::callback, this); }
