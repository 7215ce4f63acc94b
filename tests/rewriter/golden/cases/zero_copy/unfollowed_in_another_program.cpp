// Two programs of the package have no object in common: what one does not follow is no message of the other.
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

int main() {
  Pool pool;
  release = [&pool](sensor_msgs::Image& old) { pool.put(&old); };
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::Image kept;
// +tzc::sensor_msgs::Image kept;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
