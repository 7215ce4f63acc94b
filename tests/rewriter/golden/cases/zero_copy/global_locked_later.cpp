// Other files may advertise anew.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

ros::Publisher pub;
std::mutex mutex;

void publish() {
  sensor_msgs::Image image;
  image.data.resize(100);
  std::lock_guard<std::mutex> lock(mutex);
  pub.publish(image);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  publish();
}
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
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
