// The index is valid only behind a call that may run any code of the package: where the message is born it is looked up.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <functional>

class Node {
 public:
  void by_callback(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    ros::spinOnce();
    pubs_[chosen_].publish(image);
  }
  void by_function(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    choose_();
    pubs_[chosen_].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  int chosen_ = -1;
  std::function<void()> choose_ = [this] { chosen_ = 0; };
  std::vector<ros::Publisher> pubs_{nh_.advertise<sensor_msgs::Image>("image", 1)};
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:26 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, chosen_).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, chosen_).allocate(image);
// -  std::vector<ros::Publisher> pubs_{nh_.advertise<sensor_msgs::Image>("image", 1)};
// +  std::vector<tzc::Publisher> pubs_{tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)};
