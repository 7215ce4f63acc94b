// An algorithm stores the pointer in the elements of a list.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <list>

class Node {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::list<uint8_t*> rows(2);
    std::fill(rows.begin(), rows.end(), image.data.data());
    pub_.publish(image);
    *rows.front() = 3;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data may be stored by a call
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
