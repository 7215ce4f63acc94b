// The messages of an object that is new in each call lie in an array of it.
#include <array>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Pair {
  std::array<sensor_msgs::Image, 2> images;
};

class Stereo {
 public:
  explicit Stereo(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
  void tick() {
    Pair pair;
    for (int i = 0; i < 2; ++i) {
      pair.images[i].data.resize(6000);
      pub_.publish(pair.images[i]);
    }
  }

 private:
  ros::Publisher pub_;
};

int main() {
  ros::NodeHandle nh;
  Stereo(nh).tick();
}
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1022 'pair' may be another object each time, with content outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  std::array<sensor_msgs::Image, 2> images;
// +  std::array<tzc::sensor_msgs::Image, 2> images;
// -  explicit Stereo(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("image", 1)) {}
// +  explicit Stereo(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
