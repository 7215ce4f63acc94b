// Objects that are made from a message which was not published yet, by their own constructors: each holds a copy, with elements of its own.
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int number;
};

void optional(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("optional", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::optional<sensor_msgs::Image> copy = image;
  pub.publish(*copy);
}
void tuple(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("tuple", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::tuple<sensor_msgs::Image, int> copy(image, 1);
  pub.publish(std::get<0>(copy));
}
void list(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("list", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::vector<sensor_msgs::Image> copies{image};
  pub.publish(copies[0]);
}
void number(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("number", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::vector<sensor_msgs::Image> copies(3, image);
  pub.publish(copies[0]);
}
void array(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("array", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::array<sensor_msgs::Image, 1> copies{{image}};
  pub.publish(copies[0]);
}
void entry(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("entry", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::map<int, sensor_msgs::Image> copies;
  copies[1] = image;
  pub.publish(copies[1]);
}
void aggregate(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("aggregate", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  auto frame = std::make_unique<Frame>(Frame{image, 1});
  pub.publish(frame->image);
}
void reference(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("reference", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  const sensor_msgs::Image& copy = sensor_msgs::Image(image);
  pub.publish(copy);
}
void original(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("original", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  std::vector<sensor_msgs::Image> copies{image};
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'optional'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'optional' TZC1022 it is a copy (copied into 'copy' in line 21), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'tuple'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'tuple' TZC1022 it is a copy (copied into 'copy' in line 28), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:32 sensor_msgs/Image one_copy 'list'
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'list' TZC1022 it is a copy (copied into 'copies' in line 35), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:39 sensor_msgs/Image one_copy 'number'
// publish src/node.cpp:43 sensor_msgs/Image one_copy 'number' TZC1022 it is a copy (copied into 'copies' in line 42), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'array'
// publish src/node.cpp:50 sensor_msgs/Image one_copy 'array' TZC1022 it is a copy (copied into 'copies' in line 49), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:53 sensor_msgs/Image one_copy 'entry'
// publish src/node.cpp:58 sensor_msgs/Image one_copy 'entry' TZC1019 it is an element of 'copies', and nothing shows where that makes it
// advertise src/node.cpp:61 sensor_msgs/Image one_copy 'aggregate'
// publish src/node.cpp:65 sensor_msgs/Image one_copy 'aggregate' TZC1022 it is a copy (copied into 'image' in line 64), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:68 sensor_msgs/Image one_copy 'reference'
// publish src/node.cpp:72 sensor_msgs/Image one_copy 'reference' TZC1022 it is a copy (copied into 'copy' in line 71), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:75 sensor_msgs/Image zero_copy 'original'
// publish src/node.cpp:79 sensor_msgs/Image zero_copy 'original'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("optional", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "optional", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::optional<sensor_msgs::Image> copy = image;
// +  std::optional<tzc::sensor_msgs::Image> copy = image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("tuple", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "tuple", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::tuple<sensor_msgs::Image, int> copy(image, 1);
// +  std::tuple<tzc::sensor_msgs::Image, int> copy(image, 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("list", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "list", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::vector<sensor_msgs::Image> copies{image};
// +  std::vector<tzc::sensor_msgs::Image> copies{image};
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("number", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "number", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::vector<sensor_msgs::Image> copies(3, image);
// +  std::vector<tzc::sensor_msgs::Image> copies(3, image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("array", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "array", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::array<sensor_msgs::Image, 1> copies{{image}};
// +  std::array<tzc::sensor_msgs::Image, 1> copies{{image}};
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("entry", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "entry", 1);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("aggregate", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "aggregate", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// +  pub.allocate(frame->image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("reference", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "reference", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  const sensor_msgs::Image& copy = sensor_msgs::Image(image);
// +  const tzc::sensor_msgs::Image& copy = tzc::sensor_msgs::Image(image);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("original", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "original", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  std::vector<sensor_msgs::Image> copies{image};
// +  std::vector<tzc::sensor_msgs::Image> copies{image};
