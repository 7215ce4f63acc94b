// What is copied where it is empty costs nothing. Here it is filled in between, or another array is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

class Filled {
 public:
  explicit Filled(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("filled", 1)) {}
  void tick() { pub_.publish(filled(image_)); }

 private:
  sensor_msgs::Image filled(sensor_msgs::Image& in) {
    if (in.data.empty()) {
      in.data.resize(6000);
      return in;
    }
    sensor_msgs::Image out;
    out.data.resize(6000);
    return out;
  }

  ros::Publisher pub_;
  sensor_msgs::Image image_;
};

sensor_msgs::LaserScan other_array(const sensor_msgs::LaserScan& in) {
  if (in.ranges.empty()) return in;
  sensor_msgs::LaserScan out;
  out.ranges.resize(in.ranges.size());
  return out;
}

void scan(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 1);
  sensor_msgs::LaserScan in;
  in.intensities.resize(6000);
  pub.publish(other_array(in));
}

int main() {
  ros::NodeHandle nh;
  Filled(nh).tick();
  scan(nh);
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'filled'
// publish src/node.cpp:9 sensor_msgs/Image one_copy 'filled' TZC1022 it is a copy (made in line 15), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:34 sensor_msgs/LaserScan one_copy 'scan'
// publish src/node.cpp:37 sensor_msgs/LaserScan one_copy 'scan' TZC1022 it is a copy (made in line 27), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  explicit Filled(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("filled", 1)) {}
// +  explicit Filled(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "filled", 1)) {}
// -  sensor_msgs::Image filled(sensor_msgs::Image& in) {
// +  tzc::sensor_msgs::Image filled(tzc::sensor_msgs::Image& in) {
// -    sensor_msgs::Image out;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
// -sensor_msgs::LaserScan other_array(const sensor_msgs::LaserScan& in) {
// +tzc::sensor_msgs::LaserScan other_array(const tzc::Publisher& publisher, const tzc::sensor_msgs::LaserScan& in) {
// -  sensor_msgs::LaserScan out;
// +  tzc::sensor_msgs::LaserScan out;
// +  publisher.allocate(out);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::LaserScan>("scan", 1);
// -  sensor_msgs::LaserScan in;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh, "scan", 1);
// +  tzc::sensor_msgs::LaserScan in;
// +  pub.allocate(in);
// -  pub.publish(other_array(in));
// +  pub.publish(other_array(pub, in));
