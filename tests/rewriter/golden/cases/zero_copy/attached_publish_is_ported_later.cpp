// An earlier run published with publishers that can be ported now.
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
    pubs_.push_back(nh.advertise<sensor_msgs::Image>("first", 10));
    pointer_ = &pub_;
  }
  void tick() {
    tzc::sensor_msgs::Image image;
    tzc::allocate(image);
    image.data.resize(640 * 480);
    tzc::publish(pub_, image);
    tzc::publish(pubs_[0], image);
    tzc::publish(*pointer_, image);
  }

 private:
  ros::Publisher pub_;
  std::vector<ros::Publisher> pubs_;
  ros::Publisher* pointer_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'first'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'first'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// -    pub_ = nh.advertise<sensor_msgs::Image>("image", 10);
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>("first", 10));
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "first", 10));
// -    tzc::publish(pub_, image);
// -    tzc::publish(pubs_[0], image);
// -    tzc::publish(*pointer_, image);
// +    pub_.publish(image);
// +    pubs_[0].publish(image);
// +    (*pointer_).publish(image);
// -  ros::Publisher pub_;
// -  std::vector<ros::Publisher> pubs_;
// -  ros::Publisher* pointer_;
// +  tzc::Publisher pub_;
// +  std::vector<tzc::Publisher> pubs_;
// +  tzc::Publisher* pointer_;
