// The thread runs before main advertises, and waits until a function that main calls tells it that all is there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <atomic>
#include <thread>

namespace {

ros::Publisher pub;
std::atomic<bool> is_ready{false};

void run() {
  sensor_msgs::Image image;
  image.data.resize(100);
  while (!is_ready) std::this_thread::yield();
  pub.publish(image);
}

void tell() {
  is_ready = true;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  std::thread thread(run);
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  tell();
}
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:30 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
