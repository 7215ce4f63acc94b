// What publishes here is not called by an expression that names it: the end of a derived class's object, a second name of a function, the
// copy that a handler makes of an exception, the first use of a thread's own variable, an assembler's call.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static ros::Publisher pub;

struct Base {
  virtual ~Base() {}
};
struct Plain {
  virtual ~Plain() = default;
};

namespace by_derived {
static sensor_msgs::Image image;
struct Sends : Base {
  ~Sends() { pub.publish(image); }
};
static Base* sends = new Sends;
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  delete sends;
  at[0] = 1;
}
}  // namespace by_derived

namespace by_member_of_derived {
static sensor_msgs::Image image;
struct Sender {
  ~Sender() { pub.publish(image); }
};
struct Sends : Plain {
  Sender sender;
};
static Plain* sends = new Sends;
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  sends->~Plain();
  at[0] = 1;
}
}  // namespace by_member_of_derived

namespace by_derived_of_library {
static sensor_msgs::Image image;
struct Sender {
  ~Sender() { pub.publish(image); }
};
struct Sends : std::exception {
  Sender sender;
};
static std::unique_ptr<std::exception> sends(new Sends);
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  sends.reset();
  at[0] = 1;
}
}  // namespace by_derived_of_library

namespace by_alias {
static sensor_msgs::Image image;
extern "C" void send_image() {
  pub.publish(image);
}
void other_name() __attribute__((alias("send_image")));
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  other_name();
  at[0] = 1;
}
}  // namespace by_alias

namespace by_handler {
static sensor_msgs::Image image;
struct Error {
  Error() {}
  Error(const Error&) { pub.publish(image); }
};
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  try {
    throw Error();
  } catch (Error error) {
    at[0] = 1;
  }
}
}  // namespace by_handler

namespace by_first_use {
static sensor_msgs::Image image;
struct First {
  First() { pub.publish(image); }
  int count = 0;
};
static thread_local First first;
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  first.count = 1;
  at[0] = 1;
}
}  // namespace by_first_use

namespace by_assembler {
static sensor_msgs::Image image;
extern "C" void send_another() {
  pub.publish(image);
}
void run() {
  image.data.resize(100);
  uint8_t* at = image.data.data();
  asm volatile("call send_another");
  at[0] = 1;
}
}  // namespace by_assembler

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  by_derived::run();
}
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:49 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:66 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:81 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:97 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// publish src/node.cpp:112 sensor_msgs/Image one_copy 'image' TZC1003 'at' points into its data and is used after the message may have been published
// advertise src/node.cpp:125 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -static ros::Publisher pub;
// +static tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
