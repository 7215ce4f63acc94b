// A publisher of the base class, advertised in each derived class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

class Base {
 public:
  virtual ~Base() {}
  virtual void publish() = 0;

 protected:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};

class Camera : public Base {
 public:
  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void publish() override {
    sensor_msgs::Image image;
    image.data.resize(1);
    pub_.publish(image);
  }
};

class Laser : public Base {
 public:
  Laser() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1); }
  void publish() override {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(1);
    pub_.publish(scan);
  }
};
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy
// advertise src/node.cpp:28 sensor_msgs/LaserScan zero_copy 'scan'
// publish src/node.cpp:32 sensor_msgs/LaserScan zero_copy
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Camera() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  Laser() { pub_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 1); }
// +  Laser() { pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "scan", 1); }
// -    sensor_msgs::LaserScan scan;
// +    tzc::sensor_msgs::LaserScan scan;
// +    pub_.allocate(scan);
