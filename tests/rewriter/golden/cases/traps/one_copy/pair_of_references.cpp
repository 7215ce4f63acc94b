// The members of what std::minmax returns are references to elements.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>

class Node {
 public:
  void send() {
    sensor_msgs::Image image;
    image.data.resize(100);
    const auto ends = std::minmax(image.data[0], image.data[1]);
    least_ = &ends.first;
    pub_.publish(image);
    const_cast<unsigned char&>(*least_) = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  const unsigned char* least_ = nullptr;
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'least_'
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
