// Closures that others call whenever they like write into messages that were published meanwhile.
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

class Kept {
 public:
  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {
    paint_ = [this](int k) { image_.data[k] = 1; };
    image_.data.resize(6000);
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

class Subscribed {
 public:
  explicit Subscribed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("subscribed", 1)) {
    image_.data.resize(6000);
    scan_ = nh.subscribe<sensor_msgs::LaserScan>(
        "scan", 1, [this](const sensor_msgs::LaserScanConstPtr& scan) { image_.data[scan->ranges.size()] = 1; });
  }
  void tick() { pub_.publish(image_); }

 private:
  ros::Publisher pub_;
  ros::Subscriber scan_;
  sensor_msgs::Image image_;
};

int main() {
  ros::NodeHandle nh;
  Kept kept(nh);
  Subscribed subscribed(nh);
  for (int k = 0; k < 9; ++k) {
    kept.tick(k);
    subscribed.tick();
    ros::spinOnce();
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'kept'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'kept' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:27 sensor_msgs/Image one_copy 'subscribed'
// subscribe src/node.cpp:29 sensor_msgs/LaserScan shared 'scan'
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'subscribed' TZC1022 line 30 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {
// +  explicit Kept(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "kept", 1)) {
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
// -  explicit Subscribed(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("subscribed", 1)) {
// +  explicit Subscribed(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "subscribed", 1)) {
// -    scan_ = nh.subscribe<sensor_msgs::LaserScan>(
// +    scan_ = tzc::subscribe<sensor_msgs::LaserScan>(nh,
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
