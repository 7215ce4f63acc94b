// A C name, and a symbol that the source gives, stay the same when the types change: who was compiled for the old ones is linked all the
// same, and finds them by dlsym(). Only one file can name what is static.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static ros::Publisher pub;

void start(ros::NodeHandle& nh) {
  pub = nh.advertise<sensor_msgs::Image>("image", 10);
}
extern "C" void process(sensor_msgs::Image& image) {
  image.data.resize(100);
  pub.publish(image);
}
extern "C" sensor_msgs::Image* make() {
  sensor_msgs::Image* image = new sensor_msgs::Image;
  image->data.resize(100);
  return image;
}
namespace {
extern "C" {
sensor_msgs::Image last;
static void fill(sensor_msgs::Image& image) {
  image.data.resize(100);
}
}
}  // namespace
void publish_made() {
  sensor_msgs::Image* image = make();
  pub.publish(*image);
  delete image;
}
void publish_last() {
  last.data.resize(100);
  pub.publish(last);
}
void named(sensor_msgs::Image& image) asm("process_named");
void named(sensor_msgs::Image& image) {
  image.data.resize(100);
  pub.publish(image);
}
void publish_filled() {
  sensor_msgs::Image image;
  fill(image);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1005 the symbol of 'process' does not tell its types
// publish src/node.cpp:30 sensor_msgs/Image one_copy 'image' TZC1005 the symbol of 'make' does not tell its types
// publish src/node.cpp:35 sensor_msgs/Image one_copy 'image' TZC1005 the symbol of 'last' does not tell its type
// publish src/node.cpp:40 sensor_msgs/Image one_copy 'image' TZC1005 the symbol of 'named' does not tell its types
// publish src/node.cpp:45 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -static ros::Publisher pub;
// +static tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// -static void fill(sensor_msgs::Image& image) {
// +static void fill(tzc::sensor_msgs::Image& image) {
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
