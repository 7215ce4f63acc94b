// One class publishes images and calibrations: only the images' part changes, and their declaration is cut out.
//RUN: small=4096
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh) {
    image_pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
    info_pub_ = nh.advertise<sensor_msgs::CameraInfo>("camera_info", 10);
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    image_pub_.publish(image);
    sensor_msgs::CameraInfo info;
    fill(info, n);
    info_pub_.publish(info);
  }

 private:
  void fill(sensor_msgs::CameraInfo& info, int n) { info.D.resize(n); }
  ros::Publisher info_pub_, image_pub_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:11 sensor_msgs/CameraInfo not_needed 'camera_info' its arrays are light by their type
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/CameraInfo not_needed 'camera_info' its arrays are light by their type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    image_pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// +    image_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    image_pub_.allocate(image);
// -  ros::Publisher info_pub_, image_pub_;
// +  ros::Publisher info_pub_;
// +  tzc::Publisher image_pub_;
