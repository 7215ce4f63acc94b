// A closure that others call makes the array anew before it writes; another one is called where it is made.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Kept {
 public:
  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {
    paint_ = [this](int k) {
      image_.data.assign(6000, 0);
      image_.data[k] = 1;
    };
  }
  void tick(int k) {
    paint_(k);
    pub_.publish(image_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::function<void(int)> paint_;
};

class Called {
 public:
  explicit Called(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("called", 1)) {}
  void tick(int n) {
    image_.data.assign(6000, 0);
    const auto paint = [&](int k) { image_.data[k] = 1; };
    for (int k = 0; k < n; ++k) paint(k);
    pub_.publish(image_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

int main() {
  ros::NodeHandle nh;
  Kept kept(nh);
  Called called(nh);
  for (int k = 0; k < 9; ++k) {
    kept.tick(k);
    called.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'kept'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'kept'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'called'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'called'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {
// +  explicit Kept(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "kept", 1)) {
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
// -  explicit Called(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("called", 1)) {}
// +  explicit Called(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "called", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
