// A library's function makes an object of the package, whose constructor takes what it is given, whatever that is.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <memory>

struct Keeper {
  template <class Message>
  explicit Keeper(Message& message) : elements(message.data.data()) {}
  unsigned char* elements;
};

class Node {
 public:
  void send() {
    sensor_msgs::Image image;
    image.data.resize(100);
    const auto keeper = std::make_shared<Keeper>(image);
    pub_.publish(image);
    keeper->elements[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'image' TZC1001 a library may give it to a template that takes anything
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
