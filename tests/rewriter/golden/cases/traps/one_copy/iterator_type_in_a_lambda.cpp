// A generic lambda asks what an iterator is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <type_traits>

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    const auto mark = [](auto it) { *it = std::is_class<decltype(it)>::value ? 1 : 2; };
    mark(image.data.begin());
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data goes to a closure, which asks for its type
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
