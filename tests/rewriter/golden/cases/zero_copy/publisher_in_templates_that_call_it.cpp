// Templates that only call a publisher's functions, and a declaration by decltype, do not ask for its type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class P>
bool is_wanted(const P& publisher) {
  return publisher.getNumSubscribers() > 0;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("wanted", 1);
  decltype(pub)& same = pub;
  sensor_msgs::Image image;
  image.data.resize(100);
  if (is_wanted(same)) same.publish(image);
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'wanted'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'wanted'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("wanted", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "wanted", 1);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  same.allocate(image);
