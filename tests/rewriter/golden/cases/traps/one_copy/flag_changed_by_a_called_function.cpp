// What is called in between changes the member that decides: the clear may be left out where the elements are added.
#include <sensor_msgs/Image.h>
#include <ros/ros.h>

class Tracker {
 public:
  explicit Tracker(ros::NodeHandle& nh) {
    sub_ = nh.subscribe("flag", 1, &Tracker::flag, this);
    pub_ = nh.advertise<sensor_msgs::Image>("boxes", 1);
  }
  void flag(const sensor_msgs::Image& in) { has_ = in.width > 1; next_ = in.height > 1; }
  void toggle() { has_ = next_; }
  void send(int n) {
    if (has_) out_.data.clear();
    toggle();
    for (int i = 0; i < n; ++i) {
      if (has_) {
        out_.data.push_back(i);
      }
    }
    pub_.publish(out_);
  }

 private:
  bool has_ = false, next_ = false;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  sensor_msgs::Image out_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'flag'
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'boxes'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'boxes' TZC1022 line 18 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -    sub_ = nh.subscribe("flag", 1, &Tracker::flag, this);
// -    pub_ = nh.advertise<sensor_msgs::Image>("boxes", 1);
// +    sub_ = tzc::subscribe(nh, "flag", 1, &Tracker::flag, this);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "boxes", 1);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image out_;
// +  tzc::sensor_msgs::Image out_;
