// Only some variables of a declaration are ported.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh)
      : first_(nh.advertise<std_msgs::String>("first", 1)), image_(nh.advertise<sensor_msgs::Image>("image", 1)) {
    last_ = nh.advertise<std_msgs::String>("last", 1);
    more_ = nh.advertise<std_msgs::String>("more", 1);
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    image_.publish(image);
    first_.publish(std_msgs::String());
    last_.publish(std_msgs::String());
    more_.publish(std_msgs::String());
  }

 private:
  ros::Publisher first_, image_, last_, more_;
};

void run(ros::NodeHandle& nh, int n) {
  static ros::Publisher text = nh.advertise<std_msgs::String>("text", 1),  // of words
                        *other = nullptr,                                   // of nothing
                        image = nh.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image message;
  message.data.resize(n);
  image.publish(message);
  text.publish(std_msgs::String());
}
//--- expected
// advertise src/node.cpp:9 std_msgs/String not_needed 'first'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:10 std_msgs/String not_needed 'last'
// advertise src/node.cpp:11 std_msgs/String not_needed 'more'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 std_msgs/String not_needed 'first'
// publish src/node.cpp:18 std_msgs/String not_needed 'last'
// publish src/node.cpp:19 std_msgs/String not_needed 'more'
// advertise src/node.cpp:27 std_msgs/String not_needed 'text'
// advertise src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:33 std_msgs/String not_needed 'text'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -      : first_(nh.advertise<std_msgs::String>("first", 1)), image_(nh.advertise<sensor_msgs::Image>("image", 1)) {
// +      : first_(nh.advertise<std_msgs::String>("first", 1)), image_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1)) {
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    image_.allocate(image);
// -  ros::Publisher first_, image_, last_, more_;
// +  ros::Publisher first_;
// +  tzc::Publisher image_;
// +  ros::Publisher last_, more_;
// -                        *other = nullptr,                                   // of nothing
// -                        image = nh.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image message;
// +                        *other = nullptr;                                   // of nothing
// +  static tzc::Publisher image = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  tzc::sensor_msgs::Image message;
// +  image.allocate(message);
