// One class template gets a closure in each callback.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <utility>

template <class F>
class ScopeExit {
 public:
  explicit ScopeExit(F f) : f_(std::move(f)) {}
  ~ScopeExit() { f_(); }

 private:
  F f_;
};
template <class F>
ScopeExit<F> on_exit_call(F f) { return ScopeExit<F>(std::move(f)); }

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("out", 5)) {
    sub_ = nh.subscribe("in", 5, &Node::on_image, this);
    other_ = nh.subscribe("other", 5, &Node::on_other, this);
  }
  void on_image(const sensor_msgs::ImageConstPtr& in) {
    auto done = on_exit_call([this] { ++count_; });
    sensor_msgs::Image out;
    out.data.resize(in->data.size());
    pub_.publish(out);
  }
  void on_other(const sensor_msgs::ImageConstPtr&) {
    auto done = on_exit_call([this] { count_ = 0; });
  }

 private:
  ros::Publisher pub_;
  ros::Subscriber sub_, other_;
  int count_ = 0;
};

void run(ros::NodeHandle& nh) {
  Node node(nh);
  ros::spin();
}
//--- expected
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'out'
// subscribe src/node.cpp:22 sensor_msgs/Image shared 'in'
// subscribe src/node.cpp:23 sensor_msgs/Image shared 'other'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'out'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("out", 5)) {
// -    sub_ = nh.subscribe("in", 5, &Node::on_image, this);
// -    other_ = nh.subscribe("other", 5, &Node::on_other, this);
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "out", 5)) {
// +    sub_ = tzc::subscribe(nh, "in", 5, &Node::on_image, this);
// +    other_ = tzc::subscribe(nh, "other", 5, &Node::on_other, this);
// -    sensor_msgs::Image out;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
