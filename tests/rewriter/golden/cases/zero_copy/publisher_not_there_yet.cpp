// A pointer or an iterator is valid where the message is born, and the publisher that it leads to is made later.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <vector>

void by_data(ros::NodeHandle& nh) {
  std::vector<ros::Publisher> pubs;
  pubs.reserve(2);
  ros::Publisher* pub = pubs.data();
  sensor_msgs::Image image;
  image.data.resize(101);
  pubs.push_back(nh.advertise<sensor_msgs::Image>("data", 1));
  pub->publish(image);
}

void by_iterator(ros::NodeHandle& nh) {
  std::vector<ros::Publisher> pubs;
  pubs.reserve(4);
  auto it = pubs.begin();
  sensor_msgs::Image image;
  image.data.resize(102);
  pubs.push_back(nh.advertise<sensor_msgs::Image>("iterator", 1));
  it->publish(image);
}

struct Output {
  ros::Publisher pub;
};

void deleted(ros::NodeHandle& nh, bool again) {
  Output* output = new Output{nh.advertise<sensor_msgs::Image>("deleted", 1)};
  if (output->pub.getNumSubscribers() > 7) return;
  if (!again) delete output;
  sensor_msgs::Image image;
  image.data.resize(103);
  if (again) output->pub.publish(image);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'data'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'data'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'iterator'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'iterator'
// advertise src/node.cpp:31 sensor_msgs/Image zero_copy 'deleted'
// publish src/node.cpp:36 sensor_msgs/Image zero_copy 'deleted'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::vector<ros::Publisher> pubs;
// +  std::vector<tzc::Publisher> pubs;
// -  ros::Publisher* pub = pubs.data();
// -  sensor_msgs::Image image;
// +  tzc::Publisher* pub = pubs.data();
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pubs.push_back(nh.advertise<sensor_msgs::Image>("data", 1));
// +  pubs.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "data", 1));
// -  std::vector<ros::Publisher> pubs;
// +  std::vector<tzc::Publisher> pubs;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pubs.push_back(nh.advertise<sensor_msgs::Image>("iterator", 1));
// +  pubs.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "iterator", 1));
// -  ros::Publisher pub;
// +  tzc::Publisher pub;
// -  Output* output = new Output{nh.advertise<sensor_msgs::Image>("deleted", 1)};
// +  Output* output = new Output{tzc::advertise<tzc::sensor_msgs::Image>(nh, "deleted", 1)};
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
