// Templates of the package that use iterators as any code does.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <iterator>

template <class It>
typename std::iterator_traits<It>::value_type largest(It begin, It end) {
  typename std::iterator_traits<It>::value_type found = *begin;
  for (; begin != end; ++begin)
    if (found < *begin) found = *begin;
  return found;
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    const auto count = [](auto begin, auto end) { return end - begin; };
    image.width = count(image.data.begin(), image.data.end());
    image.height = largest(image.data.begin(), image.data.end());
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
