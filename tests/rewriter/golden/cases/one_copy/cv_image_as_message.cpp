// A cv_bridge::CvImage that is published as such, by the serializer that its library has for it.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, const cv::Mat& mat) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  cv_bridge::CvImage out;
  out.encoding = "bgr8";
  out.image = mat;
  pub.publish(out);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' roscpp serializes it, and its elements are copied once more from there; publish what toImageMsg() returns
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
