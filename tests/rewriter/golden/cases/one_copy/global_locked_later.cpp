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
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub' of line 14 cannot, since another thread may be waited for in between, and may replace it
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 1);
