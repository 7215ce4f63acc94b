// A vector that is told how many pointers to put there, perhaps none: what they lead to has no name behind the declaration.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(std::size_t number) {
    std::vector<sensor_msgs::ImagePtr> images(number, boost::make_shared<sensor_msgs::Image>());
    for (std::size_t i = 0; i < images.size(); ++i) {
      images[i]->data.resize(6000);
      pub_.publish(images[i]);
    }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1019 it has no name where it is built
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
