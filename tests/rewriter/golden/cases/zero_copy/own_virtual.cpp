// The helper overrides a function of the package: both are ported.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Source {
 public:
  virtual ~Source() {}
  virtual void fill(sensor_msgs::Image& image) = 0;
};

class Camera : public Source {
 public:
  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void fill(sensor_msgs::Image& image) override { image.data.resize(10); }
  void publish() {
    sensor_msgs::Image image;
    fill(image);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  virtual void fill(sensor_msgs::Image& image) = 0;
// +  virtual void fill(tzc::sensor_msgs::Image& image) = 0;
// -  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// -  void fill(sensor_msgs::Image& image) override { image.data.resize(10); }
// +  Camera() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// +  void fill(tzc::sensor_msgs::Image& image) override { image.data.resize(10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
