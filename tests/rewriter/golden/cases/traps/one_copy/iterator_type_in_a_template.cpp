// A template asks what an iterator is: a class, which becomes a pointer.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

template <class It>
void mark(It begin, It end) {
  for (; begin != end; ++begin) *begin = std::is_pointer<It>::value ? 1 : 2;
}

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    mark(image.data.begin(), image.data.end());
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to 'mark', which asks for its type
// advertise src/node.cpp:23 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
