// The publishers stay as they are where the program asks for their type: in a template, by decltype, in what is made of one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

template <class P>
bool is_wanted(const P& publisher) {
  if constexpr (std::is_same_v<P, ros::Publisher>)
    return publisher.getNumSubscribers() > 0;
  else
    return false;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("wanted", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  if (is_wanted(pub)) pub.publish(image);
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    image.step = is_plain ? 1 : 2;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("member", 1);
  static constexpr bool is_plain = std::is_same<decltype(pub_), ros::Publisher>::value;
};
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'wanted'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'wanted'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'member'
// advertise src/node.cpp:33 sensor_msgs/Image zero_copy 'member'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("wanted", 1);
// -  sensor_msgs::Image image;
// +  ros::Publisher pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("wanted", 1));
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  if (is_wanted(pub)) pub.publish(image);
// +  if (is_wanted(pub)) tzc::publish(pub, image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    pub_.publish(image);
// +    tzc::publish(pub_, image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("member", 1);
// +  ros::Publisher pub_ = tzc::attached<sensor_msgs::Image>(nh_.advertise<sensor_msgs::Image>("member", 1));
