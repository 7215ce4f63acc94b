// A copy of a message that was published shares its elements with it.
#include <deque>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh)
      : pub_(nh.advertise<sensor_msgs::Image>("image", 1)), again_(nh.advertise<sensor_msgs::Image>("again", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(image);
    queue_.push_back(image);
    again_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_, again_;
  std::deque<sensor_msgs::Image> queue_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'again'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'again'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -      : pub_(nh.advertise<sensor_msgs::Image>("image", 1)), again_(nh.advertise<sensor_msgs::Image>("again", 1)) {}
// +      : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)), again_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "again", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_, again_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_, again_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
