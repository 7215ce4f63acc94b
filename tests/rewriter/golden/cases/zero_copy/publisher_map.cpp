// Publishers in maps: to name one early must not add an entry.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <unordered_map>

class Node {
 public:
  Node() {
    pubs_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1);
    numbered_[7] = nh_.advertise<sensor_msgs::Image>("seven", 1);
  }
  void publish(const std::string& name) {
    sensor_msgs::Image image;
    image.data.resize(1);
    if (pubs_.count(name)) pubs_[name].publish(image);
  }
  void publish_left() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(1);
    this->pubs_["left"].publish(image);
  }
  void publish_number(int number) {
    sensor_msgs::Image image;
    image.data.resize(1);
    numbered_[number].publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::map<std::string, ros::Publisher> pubs_;
  std::unordered_map<int, ros::Publisher> numbered_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'seven'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:27 sensor_msgs/Image zero_copy 'seven'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1);
// -    numbered_[7] = nh_.advertise<sensor_msgs::Image>("seven", 1);
// +    pubs_["left"] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1);
// +    numbered_[7] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "seven", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, name).allocate(image);
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    tzc::find_publisher(this->pubs_, "left").allocate(*image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(numbered_, number).allocate(image);
// -  std::map<std::string, ros::Publisher> pubs_;
// -  std::unordered_map<int, ros::Publisher> numbered_;
// +  std::map<std::string, tzc::Publisher> pubs_;
// +  std::unordered_map<int, tzc::Publisher> numbered_;
