// The other file has no main(): it may be part of the same program, and its closure may get the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::Image kept;

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
  for (;;) {
    kept.data.clear();
    kept.data.resize(100);
    pub.publish(kept);
  }
}
//--- src/other.cpp
#include <functional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Pool {
  void put(sensor_msgs::Image* image) { image->data.clear(); }
};

std::function<void(sensor_msgs::Image&)> release;

void use(Pool& pool) {
  release = [&pool](sensor_msgs::Image& old) { pool.put(&old); };
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 line 13 of other.cpp uses a sensor_msgs/Image, and nothing shows which: it may be this one, and be written to after this publish
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image kept;
// +tzc::sensor_msgs::Image kept;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
