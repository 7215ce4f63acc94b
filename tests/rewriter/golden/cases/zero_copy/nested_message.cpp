// A message with a message that has the array.
#include <ros/ros.h>
#include <stereo_msgs/DisparityImage.h>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<stereo_msgs::DisparityImage>("image", 10);
  stereo_msgs::DisparityImagePtr disparity = boost::make_shared<stereo_msgs::DisparityImage>();
  sensor_msgs::Image& image = disparity->image;
  image.data.resize(100);
  pub.publish(disparity);
}
//--- expected
// advertise src/node.cpp:6 stereo_msgs/DisparityImage zero_copy 'image'
// publish src/node.cpp:10 stereo_msgs/DisparityImage zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/stereo_msgs/DisparityImage.h>
// -  ros::Publisher pub = nh.advertise<stereo_msgs::DisparityImage>("image", 10);
// -  stereo_msgs::DisparityImagePtr disparity = boost::make_shared<stereo_msgs::DisparityImage>();
// -  sensor_msgs::Image& image = disparity->image;
// +  tzc::Publisher pub = tzc::advertise<tzc::stereo_msgs::DisparityImage>(nh, "image", 10);
// +  tzc::stereo_msgs::DisparityImagePtr disparity = boost::make_shared<tzc::stereo_msgs::DisparityImage>();
// +  pub.allocate(*disparity);
// +  tzc::sensor_msgs::Image& image = disparity->image;
