// What a call through the base class runs writes to what is new by then, or makes it so.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Base {
 public:
  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  virtual ~Base() {}
  virtual void start(sensor_msgs::Image& image) = 0;
  virtual void paint(int k) = 0;
  void tick(int k) {
    start(image_);
    paint(k);
    pub_.publish(image_);
  }

 protected:
  sensor_msgs::Image image_;

 private:
  ros::Publisher pub_;
};
struct Dots : Base {
  using Base::Base;
  void start(sensor_msgs::Image& image) override { image.data.assign(6000, 0); }
  void paint(int k) override { image_.data[k] = 1; }
};

int main() {
  ros::NodeHandle nh;
  Dots dots(nh);
  for (int k = 0; k < 9; ++k) dots.tick(k);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Base(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -  virtual void start(sensor_msgs::Image& image) = 0;
// +  virtual void start(tzc::sensor_msgs::Image& image) = 0;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  void start(sensor_msgs::Image& image) override { image.data.assign(6000, 0); }
// +  void start(tzc::sensor_msgs::Image& image) override { image.data.assign(6000, 0); }
