// A constructor's initializer list makes the message, of which the first publish copies the elements: the only one that its object lives for.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh)
      : pub_(nh.advertise<sensor_msgs::Image>("image", 1)), image_(new sensor_msgs::Image) {
    image_->data.resize(640 * 480);
  }
  void send() { pub_.publish(*image_); }

 private:
  ros::Publisher pub_;
  sensor_msgs::ImagePtr image_;
};

void run(ros::NodeHandle& nh) {
  Camera camera(nh);
  camera.send();
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1019 a constructor's initializer list makes it, where no statement can stand
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -      : pub_(nh.advertise<sensor_msgs::Image>("image", 1)), image_(new sensor_msgs::Image) {
// +      : pub_(tzc::advertise<sensor_msgs::Image>(nh, "image", 1)), image_(new sensor_msgs::Image) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
