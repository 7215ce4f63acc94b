// A template advertises a type that it takes from its parameter: each instance would need another edit.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

struct Images {
  typedef sensor_msgs::Image Message;
};
struct Clouds {
  typedef sensor_msgs::PointCloud2 Message;
};

template <class Kind>
ros::Publisher advertise(ros::NodeHandle& nh) {
  return nh.advertise<typename Kind::Message>("topic", 1);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher images = advertise<Images>(nh);
  ros::Publisher clouds = advertise<Clouds>(nh);
  images.publish(sensor_msgs::Image());
  clouds.publish(sensor_msgs::PointCloud2());
}
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image one_copy 'topic' TZC1007 the instances of a template advertise different types here
// advertise src/node.cpp:15 sensor_msgs/PointCloud2 one_copy 'topic' TZC1007 the instances of a template advertise different types here
// publish src/node.cpp:21 sensor_msgs/Image one_copy TZC1019 where it is built was not found
// publish src/node.cpp:22 sensor_msgs/PointCloud2 one_copy TZC1019 where it is built was not found
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  return nh.advertise<typename Kind::Message>("topic", 1);
// +  return tzc::attached<typename Kind::Message>(nh.advertise<typename Kind::Message>("topic", 1));
