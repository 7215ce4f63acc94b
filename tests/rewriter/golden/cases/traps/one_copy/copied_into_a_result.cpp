// A copy of the array is returned, and the result's type is deduced.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void tick() {
    image_.data.assign(40000, 1);
    pub_.publish(image_);
  }
  auto pixels() const { return image_.data; }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image image_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is returned
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Camera(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Camera(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "image", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
