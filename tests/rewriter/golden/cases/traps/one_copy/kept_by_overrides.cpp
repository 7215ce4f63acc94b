// A call through the base class runs an override, which writes what it is given after it was published.
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Painter {
  virtual ~Painter() {}
  virtual void paint(sensor_msgs::Image& image, int k) = 0;
};
struct Dots : Painter {
  void paint(sensor_msgs::Image& image, int k) override { image.data[k] = 1; }
};

class Before {
 public:
  explicit Before(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("before", 1)), painter_(new Dots) {
    image_.data.resize(6000);
  }
  void tick(int k) {
    painter_->paint(image_, k);
    pub_.publish(image_);
  }

 private:
  ros::Publisher pub_;
  std::unique_ptr<Painter> painter_;
  sensor_msgs::Image image_;
};

class Base {
 public:
  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("after", 1)) {}
  virtual ~Base() {}
  virtual void published(sensor_msgs::Image&) {}
  void tick(int k) {
    image_.data.assign(6000, k);
    pub_.publish(image_);
    published(image_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
struct After : Base {
  using Base::Base;
  void published(sensor_msgs::Image& image) override { image.data[0] = 0; }
};

int main() {
  ros::NodeHandle nh;
  Before before(nh);
  After after(nh);
  for (int k = 0; k < 9; ++k) {
    before.tick(k);
    after.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'before'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'before' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:33 sensor_msgs/Image one_copy 'after'
// publish src/node.cpp:38 sensor_msgs/Image one_copy 'after' TZC1022 line 48 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  virtual void paint(sensor_msgs::Image& image, int k) = 0;
// +  virtual void paint(tzc::sensor_msgs::Image& image, int k) = 0;
// -  void paint(sensor_msgs::Image& image, int k) override { image.data[k] = 1; }
// +  void paint(tzc::sensor_msgs::Image& image, int k) override { image.data[k] = 1; }
// -  explicit Before(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("before", 1)), painter_(new Dots) {
// +  explicit Before(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "before", 1)), painter_(new Dots) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::sensor_msgs::Image image_;
// -  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("after", 1)) {}
// +  explicit Base(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "after", 1)) {}
// -  virtual void published(sensor_msgs::Image&) {}
// +  virtual void published(tzc::sensor_msgs::Image&) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image image_;
// -  void published(sensor_msgs::Image& image) override { image.data[0] = 0; }
// +  void published(tzc::sensor_msgs::Image& image) override { image.data[0] = 0; }
