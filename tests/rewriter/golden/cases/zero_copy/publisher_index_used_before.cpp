// The publisher is asked for subscribers in any case: it can be named where the message is born, too.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Output {
  ros::Publisher publisher;
  bool enabled = true;
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : output_(new Output) {
    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image", 1));
    output_->publisher = nh.advertise<sensor_msgs::Image>("other", 1);
  }
  void publish(unsigned i) {
    sensor_msgs::Image image;
    image.data.resize(i);
    if (pubs_[i].getNumSubscribers() > 0) pubs_[i].publish(image);
  }
  void publish_other() {
    if (!output_->enabled) return;
    sensor_msgs::Image image;
    image.data.resize(1);
    if (output_->publisher.getNumSubscribers() > 0) output_->publisher.publish(image);
  }

 private:
  Output* output_;
  std::vector<ros::Publisher> pubs_;
};
//--- expected
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'other'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'other'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher publisher;
// +  tzc::Publisher publisher;
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image", 1));
// -    output_->publisher = nh.advertise<sensor_msgs::Image>("other", 1);
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1));
// +    output_->publisher = tzc::advertise<tzc::sensor_msgs::Image>(nh, "other", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[i].allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    output_->publisher.allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;
