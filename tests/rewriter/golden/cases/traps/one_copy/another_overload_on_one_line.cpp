// Functions that stand on one line, or that one macro writes, are told apart: a ported message would be given to another one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Show { int operator()(const std::vector<uint8_t>& v) { return v.size() > 3 ? 7 : 5; } template <class T> int operator()(const T&) { return 9; } };
struct Sum { int n = 0; Sum(const std::vector<uint8_t>& v) : n(v.size() > 3 ? 7 : 5) {} template <class T> Sum(const T&) : n(9) {} };
template <class... F> struct Overloaded : F... { using F::operator()...; };
template <class... F> Overloaded(F...) -> Overloaded<F...>;
#define OVERLOADS(name)                                                   \
  inline int name(const std::vector<uint8_t>& v) { return v.size() > 3; } \
  template <class T>                                                      \
  int name(const T&) {                                                    \
    return 9;                                                             \
  }
OVERLOADS(check)

void object(const ros::Publisher& pub) {
  Show show;
  sensor_msgs::Image image;
  image.data.assign(10000, 1);
  image.width = show(image.data);
  pub.publish(image);
}
void constructor(const ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.assign(10000, 1);
  image.width = Sum(image.data).n;
  pub.publish(image);
}
void lambdas(const ros::Publisher& pub) {
  auto show = Overloaded{[](const std::vector<uint8_t>& v) { return v.size() > 3 ? 7 : 5; }, [](const auto&) { return 9; }};
  sensor_msgs::Image image;
  image.data.assign(10000, 1);
  image.width = show(image.data);
  pub.publish(image);
}
void macro(const ros::Publisher& pub) {
  sensor_msgs::Image image;
  image.data.assign(10000, 1);
  image.width = check(image.data);
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  object(pub);
  constructor(pub);
  lambdas(pub);
  macro(pub);
}
//--- expected
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'Show::operator()' than before
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'Sum::Sum' than before
// publish src/node.cpp:35 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another lambda in 'lambdas' than before
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'image' TZC1009 ported, this call would choose another 'check' than before
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void object(const ros::Publisher& pub) {
// +void object(const tzc::Publisher& pub) {
// -void constructor(const ros::Publisher& pub) {
// +void constructor(const tzc::Publisher& pub) {
// -void lambdas(const ros::Publisher& pub) {
// +void lambdas(const tzc::Publisher& pub) {
// -void macro(const ros::Publisher& pub) {
// +void macro(const tzc::Publisher& pub) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
