// The message is not the first element of the pack whose types are asked.
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

template <class... Ms>
void stamp_all(const ros::Time& now, Ms&... messages) {
  const int in_order[] = {(messages.header.stamp = now, 0)...};
  const int then[] = {
      (messages.header.frame_id = std::is_same<Ms, sensor_msgs::Image>::value ? "camera" : "other", 0)...};
  (void)in_order, (void)then;
}

void run(ros::NodeHandle& nh, int n) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher pose_pub = nh.advertise<geometry_msgs::PoseStamped>("pose", 1);
  geometry_msgs::PoseStamped pose;
  sensor_msgs::Image image;
  image.data.resize(n);
  stamp_all(ros::Time::now(), pose, image);
  pose_pub.publish(pose);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:18 geometry_msgs/PoseStamped not_needed 'pose'
// publish src/node.cpp:23 geometry_msgs/PoseStamped not_needed 'pose'
// publish src/node.cpp:24 sensor_msgs/Image one_copy 'image' TZC1001 'stamp_all' asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
