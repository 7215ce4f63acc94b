// A map's [] makes what it does not find, and the constructor publishes while a pointer into the data is there.
#include <cstring>
#include <map>
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node;
struct Source {
  Source();
  unsigned char pixel = 0;
};

class Node {
 public:
  void send() { pub_.publish(image_); }
  void tick() {
    image_.data.assign(10000, 1);
    std::memcpy(&image_.data[0], &by_number_[3].pixel, 1);
    send();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  std::map<int, Source> by_number_;
};
Node* node = nullptr;
Source::Source() {
  if (node) node->send();
}
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after the message may have been published
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
