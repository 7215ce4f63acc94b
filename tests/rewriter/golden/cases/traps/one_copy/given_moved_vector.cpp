// A vector's elements lie outside shared memory: publishing copies them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<uint8_t> render();

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    std::vector<uint8_t> pixels(100);
    image.data = std::move(pixels);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  std::vector<uint8_t> pixels_;
  std::vector<uint8_t> empty_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1022 line 13 gives it elements that lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
