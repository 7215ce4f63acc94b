// Options in a template of a header: each instance has a message of its own, and one unit has no instance.
#include <node/listen.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

void on_image(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }
void on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) { ROS_INFO("%zu bytes", cloud->data.size()); }

int main() {
  ros::NodeHandle nh;
  ros::Subscriber image = listen<sensor_msgs::Image>(nh, "image", on_image);
  ros::Subscriber cloud = listen<sensor_msgs::PointCloud2>(nh, "cloud", on_cloud);
  ros::spin();
}
//--- include/node/listen.h
#pragma once
#include <ros/ros.h>

template <class M>
ros::Subscriber listen(ros::NodeHandle& nh, const std::string& topic,
                       boost::function<void(const boost::shared_ptr<M const>&)> callback) {
  ros::SubscribeOptions options;
  options.init<M>(topic, 1, callback);
  return nh.subscribe(options);
}
//--- src/other.cpp
#include <node/listen.h>
//--- expected
// subscribe include/node/listen.h:9 sensor_msgs/Image copied TZC2001 the callback is not known here, and pages that it writes to are copied
// subscribe include/node/listen.h:9 sensor_msgs/PointCloud2 copied TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ include/node/listen.h
// +#include <tzc/ros.h>
// -  return nh.subscribe(options);
// +  return tzc::subscribe<M>(nh, options);
