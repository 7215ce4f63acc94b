// What is kept is compared with what comes in: nothing is copied for that.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Filter {
 public:
  Filter() : pub_(nh_.advertise<sensor_msgs::Image>("changed", 1)), sub_(nh_.subscribe("image", 1, &Filter::take, this)) {}
  void take(const sensor_msgs::ImageConstPtr& in) {
    if (last_ == *in || !(*in != last_)) return;
    last_ = *in;
    pub_.publish(last_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  sensor_msgs::Image last_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'changed'
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'changed'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Filter() : pub_(nh_.advertise<sensor_msgs::Image>("changed", 1)), sub_(nh_.subscribe("image", 1, &Filter::take, this)) {}
// +  Filter() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "changed", 1)), sub_(tzc::subscribe(nh_, "image", 1, &Filter::take, this)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image last_;
// +  tzc::sensor_msgs::Image last_;
