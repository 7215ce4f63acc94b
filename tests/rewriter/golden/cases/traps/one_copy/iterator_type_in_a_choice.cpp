// Inside a template, one of two functions is chosen by what the iterator is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

inline int rank(...) { return 1; }
template <class It>
auto rank(It it) -> decltype(it.base(), 0) {
  return 2;
}
template <class It>
int rank_of(It it) {
  return rank(it);
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    image.width = rank_of(image.data.begin());
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:23 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'rank_of', which asks for its type
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
