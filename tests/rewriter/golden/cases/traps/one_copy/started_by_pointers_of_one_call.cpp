// Objects that live as long as a call start with a message each time, whose only publish copies it; each subscribes.
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  ros::Subscriber sub;
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
};
struct Listed {
  ros::Subscriber sub;
  Listed() : image(new sensor_msgs::Image) {}
  std::unique_ptr<sensor_msgs::Image> image;
};
struct Around {
  Listed listed;
  int count = 0;
};

void by_default(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_default", 1);
  Frame frame;
  frame.image->data.resize(6000);
  pub.publish(*frame.image);
}
void by_braces(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_braces", 1);
  Frame frame{};
  frame.image->data.resize(6000);
  pub.publish(frame.image);
}
void on_heap(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("on_heap", 1);
  auto frame = std::make_shared<Frame>();
  frame->image->data.resize(6000);
  pub.publish(*frame->image);
}
void by_constructor(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_constructor", 1);
  Listed listed;
  listed.image->data.resize(6000);
  pub.publish(*listed.image);
}
void inside(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("inside", 1);
  const auto around = std::make_unique<Around>();
  around->listed.image->data.resize(6000);
  pub.publish(*around->listed.image);
}
//--- expected
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'by_default'
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'by_default' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'by_braces'
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'by_braces' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// advertise src/node.cpp:34 sensor_msgs/Image one_copy 'on_heap'
// publish src/node.cpp:37 sensor_msgs/Image one_copy 'on_heap' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// advertise src/node.cpp:40 sensor_msgs/Image one_copy 'by_constructor'
// publish src/node.cpp:43 sensor_msgs/Image one_copy 'by_constructor' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'inside'
// publish src/node.cpp:49 sensor_msgs/Image one_copy 'inside' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
// +  tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>();
// -  Listed() : image(new sensor_msgs::Image) {}
// -  std::unique_ptr<sensor_msgs::Image> image;
// +  Listed() : image(new tzc::sensor_msgs::Image) {}
// +  std::unique_ptr<tzc::sensor_msgs::Image> image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_default", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_default", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_braces", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_braces", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("on_heap", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "on_heap", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_constructor", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "by_constructor", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("inside", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "inside", 1);
