// An address in a shared cv::Mat that was a number meanwhile.
#include <cstdint>
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void callback(const sensor_msgs::ImageConstPtr& image) {
  const cv::Mat mat = cv_bridge::toCvShare(image)->image;
  *reinterpret_cast<uint8_t*>(reinterpret_cast<std::uintptr_t>(mat.data) + 1) = 1;
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, callback);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image copied 'image' TZC2001 the cv::Mat that shares its data may be written to: pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe("image", 1, callback);
// +  ros::Subscriber sub = tzc::subscribe(nh, "image", 1, callback);
