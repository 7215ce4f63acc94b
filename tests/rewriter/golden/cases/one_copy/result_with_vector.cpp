// Functions whose results have a vector's elements: the publish of the result copies them.
#include <utility>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<unsigned char> pixels(int k);

sensor_msgs::ImagePtr swapped(int k) {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  std::vector<unsigned char> built = pixels(k);
  image->data.swap(built);
  return image;
}

sensor_msgs::Image by_value(int k) {
  sensor_msgs::Image image;
  image.data = pixels(k);
  return image;
}

sensor_msgs::Image twice(int k) {
  if (k % 2 == 0) return by_value(k);
  return by_value(k + 1);
}

sensor_msgs::ImageConstPtr filled(int k) {
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
  image->data.resize(5000);
  for (int i = 0; i < 5000; ++i) image->data[i] = k + i;
  return image;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher first = nh.advertise<sensor_msgs::Image>("first", 1);
  ros::Publisher second = nh.advertise<sensor_msgs::Image>("second", 1);
  ros::Publisher third = nh.advertise<sensor_msgs::Image>("third", 1);
  ros::Publisher fourth = nh.advertise<sensor_msgs::Image>("fourth", 1);
  for (int k = 0; ros::ok(); ++k) {
    sensor_msgs::ImagePtr image = swapped(k);
    first.publish(image);
    second.publish(by_value(k));
    sensor_msgs::Image other = twice(k);
    other.height = 3;
    third.publish(other);
    const sensor_msgs::ImageConstPtr last = filled(k);
    fourth.publish(last);
  }
}
//--- expected
// advertise src/node.cpp:36 sensor_msgs/Image one_copy 'first'
// advertise src/node.cpp:37 sensor_msgs/Image one_copy 'second'
// advertise src/node.cpp:38 sensor_msgs/Image one_copy 'third'
// advertise src/node.cpp:39 sensor_msgs/Image zero_copy 'fourth'
// publish src/node.cpp:42 sensor_msgs/Image one_copy 'first' TZC1022 line 13 gives it elements that lie outside shared memory
// publish src/node.cpp:43 sensor_msgs/Image one_copy 'second' TZC1022 line 19 gives it elements that lie outside shared memory
// publish src/node.cpp:46 sensor_msgs/Image one_copy 'third' TZC1022 line 19 gives it elements that lie outside shared memory
// publish src/node.cpp:48 sensor_msgs/Image zero_copy 'fourth'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr swapped(int k) {
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +tzc::sensor_msgs::ImagePtr swapped(const tzc::Publisher& publisher, int k) {
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  publisher.allocate(*image);
// -sensor_msgs::Image by_value(int k) {
// -  sensor_msgs::Image image;
// +tzc::sensor_msgs::Image by_value(const tzc::Publisher& publisher, int k) {
// +  tzc::sensor_msgs::Image image;
// +  publisher.allocate(image);
// -sensor_msgs::Image twice(int k) {
// -  if (k % 2 == 0) return by_value(k);
// -  return by_value(k + 1);
// +tzc::sensor_msgs::Image twice(const tzc::Publisher& publisher, int k) {
// +  if (k % 2 == 0) return by_value(publisher, k);
// +  return by_value(publisher, k + 1);
// -sensor_msgs::ImageConstPtr filled(int k) {
// -  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
// -  image->data.resize(5000);
// +tzc::sensor_msgs::ImageConstPtr filled(const tzc::Publisher& publisher, int k) {
// +  tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>();
// +  publisher.allocate(*image);
// +  image->data.resize(5000, tzc::uninitialized);
// -  ros::Publisher first = nh.advertise<sensor_msgs::Image>("first", 1);
// -  ros::Publisher second = nh.advertise<sensor_msgs::Image>("second", 1);
// -  ros::Publisher third = nh.advertise<sensor_msgs::Image>("third", 1);
// -  ros::Publisher fourth = nh.advertise<sensor_msgs::Image>("fourth", 1);
// +  tzc::Publisher first = tzc::advertise<tzc::sensor_msgs::Image>(nh, "first", 1);
// +  tzc::Publisher second = tzc::advertise<tzc::sensor_msgs::Image>(nh, "second", 1);
// +  tzc::Publisher third = tzc::advertise<tzc::sensor_msgs::Image>(nh, "third", 1);
// +  tzc::Publisher fourth = tzc::advertise<tzc::sensor_msgs::Image>(nh, "fourth", 1);
// -    sensor_msgs::ImagePtr image = swapped(k);
// +    tzc::sensor_msgs::ImagePtr image = swapped(first, k);
// -    second.publish(by_value(k));
// -    sensor_msgs::Image other = twice(k);
// +    second.publish(by_value(second, k));
// +    tzc::sensor_msgs::Image other = twice(second, k);
// -    const sensor_msgs::ImageConstPtr last = filled(k);
// +    const tzc::sensor_msgs::ImageConstPtr last = filled(fourth, k);
