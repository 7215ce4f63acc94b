// A local pointer gets its publisher behind the message, in each call: asked where the message is born, it would always be null.
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void by_reset() {
    std::unique_ptr<ros::Publisher> pub;
    sensor_msgs::Image image;
    image.data.resize(101);
    pub.reset(new ros::Publisher(pub_));
    pub->publish(image);
  }
  void by_assignment() {
    std::shared_ptr<ros::Publisher> pub;
    sensor_msgs::Image image;
    image.data.resize(102);
    if (image.data[0] == 0) pub = std::make_shared<ros::Publisher>(pub_);
    if (pub) pub->publish(image);
  }
  void by_reference() {
    std::shared_ptr<ros::Publisher> pub;
    auto& same = pub;
    sensor_msgs::Image image;
    image.data.resize(103);
    same = std::make_shared<ros::Publisher>(pub_);
    pub->publish(image);
  }
  void given(std::shared_ptr<ros::Publisher> pub) {
    sensor_msgs::Image image;
    image.data.resize(104);
    if (pub) pub->publish(image);
  }
  void lasting() {
    static std::shared_ptr<ros::Publisher> pub;
    sensor_msgs::Image image;
    image.data.resize(105);
    if (!pub) pub = std::make_shared<ros::Publisher>(pub_);
    pub->publish(image);
  }
  void all() { given(std::make_shared<ros::Publisher>(pub_)); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:41 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -    std::unique_ptr<ros::Publisher> pub;
// -    sensor_msgs::Image image;
// +    std::unique_ptr<tzc::Publisher> pub;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    pub.reset(new ros::Publisher(pub_));
// +    pub.reset(new tzc::Publisher(pub_));
// -    std::shared_ptr<ros::Publisher> pub;
// -    sensor_msgs::Image image;
// +    std::shared_ptr<tzc::Publisher> pub;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    if (image.data[0] == 0) pub = std::make_shared<ros::Publisher>(pub_);
// +    if (image.data[0] == 0) pub = std::make_shared<tzc::Publisher>(pub_);
// -    std::shared_ptr<ros::Publisher> pub;
// +    std::shared_ptr<tzc::Publisher> pub;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    same = std::make_shared<ros::Publisher>(pub_);
// +    same = std::make_shared<tzc::Publisher>(pub_);
// -  void given(std::shared_ptr<ros::Publisher> pub) {
// -    sensor_msgs::Image image;
// +  void given(std::shared_ptr<tzc::Publisher> pub) {
// +    tzc::sensor_msgs::Image image;
// +    if (pub) pub->allocate(image);
// -    static std::shared_ptr<ros::Publisher> pub;
// -    sensor_msgs::Image image;
// +    static std::shared_ptr<tzc::Publisher> pub;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    if (!pub) pub = std::make_shared<ros::Publisher>(pub_);
// +    if (!pub) pub = std::make_shared<tzc::Publisher>(pub_);
// -  void all() { given(std::make_shared<ros::Publisher>(pub_)); }
// +  void all() { given(std::make_shared<tzc::Publisher>(pub_)); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
