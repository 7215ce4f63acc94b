// A tuple with a publisher.
#include <functional>
#include <future>
#include <map>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <thread>
#include <vector>

#include <tuple>
void run(ros::NodeHandle& nh) {
  auto entry = std::make_tuple(1, nh.advertise<sensor_msgs::Image>("image", 10));
  sensor_msgs::Image image;
  image.data.resize(100);
  std::get<1>(entry).publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'std::get<1>(entry)' of line 15 cannot, since to name it, the program calls a function, assigns, converts a pointer, or reads what is volatile
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  auto entry = std::make_tuple(1, nh.advertise<sensor_msgs::Image>("image", 10));
// +  auto entry = std::make_tuple(1, tzc::advertise<sensor_msgs::Image>(nh, "image", 10));
