// Where the message is made, the publisher's name is private to a base, or of another namespace.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Base {
 public:
  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("private", 1)) {}

 protected:
  void send(const sensor_msgs::Image& image) { pub_.publish(image); }

 private:
  ros::Publisher pub_;
};

class Camera : public Base {
 public:
  using Base::Base;
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    send(image);
  }
};

namespace driver {
ros::Publisher pub;
void send(const sensor_msgs::Image& image) { pub.publish(image); }
}  // namespace driver

void tick() {
  sensor_msgs::Image image;
  image.data.resize(6000);
  driver::send(image);
}

int main() {
  ros::NodeHandle nh;
  driver::pub = nh.advertise<sensor_msgs::Image>("namespace", 1);
  Camera(nh).tick();
  tick();
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'private'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'private'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'namespace'
// advertise src/node.cpp:39 sensor_msgs/Image zero_copy 'namespace'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Base(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("private", 1)) {}
// +  explicit Base(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "private", 1)) {}
// -  void send(const sensor_msgs::Image& image) { pub_.publish(image); }
// +  void send(const tzc::sensor_msgs::Image& image) { pub_.publish(image); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -ros::Publisher pub;
// -void send(const sensor_msgs::Image& image) { pub.publish(image); }
// +tzc::Publisher pub;
// +void send(const tzc::sensor_msgs::Image& image) { pub.publish(image); }
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  driver::pub = nh.advertise<sensor_msgs::Image>("namespace", 1);
// +  driver::pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "namespace", 1);
