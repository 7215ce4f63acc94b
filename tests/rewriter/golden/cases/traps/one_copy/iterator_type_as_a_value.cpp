// A template makes an object that says what an iterator is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

template <class It>
bool raw(It) {
  return std::is_pointer<It>();
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    auto it = image.data.begin();
    image.is_bigendian = raw(it + 1);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'raw', which asks for its type
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
