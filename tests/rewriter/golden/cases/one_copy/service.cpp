// The message is part of a service.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace sensor_msgs {
template <class A>
struct SetImageRequest_ {
  sensor_msgs::Image image;
  FAKE_MEMBERS(SetImageRequest_)
};
typedef SetImageRequest_<std::allocator<void>> SetImageRequest;
struct SetImage {
  typedef SetImageRequest Request;
  Request request;
};
}  // namespace sensor_msgs

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::SetImageRequest request;
  request.image.data.resize(1);
  pub.publish(request.image);
}
//--- expected
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC1002 it is part of a service
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);
