// A template keeps something for each type that it is given.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

template <class It>
int calls(It) {
  static int count = 0;
  return ++count;
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    uint8_t raw[1];
    calls(&raw[0]);
    image.width = calls(image.data.begin());
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'calls', which asks for its type
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
