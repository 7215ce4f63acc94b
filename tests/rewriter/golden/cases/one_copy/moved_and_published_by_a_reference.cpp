// A member that is filled, moved into a new message, and published by an object that refers to that one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Sender {
  ros::Publisher& pub;
  const sensor_msgs::Image& image;
  ~Sender() { pub.publish(image); }
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void send(int k) {
    frame_.data.resize(100);
    frame_.data[0] = k;
    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(frame_)));
    Sender sender{pub_, *next};
  }
  void send_directly(int k) {
    other_.data.resize(100);
    other_.data[0] = k;
    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(other_)));
    pub_.publish(next);
  }
  void send_element(int k) {
    sensor_msgs::Image& image = frames_[k % 2];
    image.data.resize(100);
    image.data[0] = k;
    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(image)));
    pub_.publish(next);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image frame_, other_, frames_[2];
};
//--- expected
// publish src/node.cpp:8 sensor_msgs/Image one_copy 'image' TZC1022 its elements come from a message that is never published itself (moved to 'next' in line 17), and lie outside shared memory
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image one_copy 'image' TZC1022 its elements come from a message that is never published itself (moved to 'next' in line 23), and lie outside shared memory
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'image' TZC1022 its elements come from a message that is never published itself (moved to 'next' in line 30), and lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher& pub;
// -  const sensor_msgs::Image& image;
// +  tzc::Publisher& pub;
// +  const tzc::sensor_msgs::Image& image;
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(frame_)));
// +    tzc::sensor_msgs::ImagePtr next(new tzc::sensor_msgs::Image(std::move(frame_)));
// -    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(other_)));
// +    tzc::sensor_msgs::ImagePtr next(new tzc::sensor_msgs::Image(std::move(other_)));
// -    sensor_msgs::Image& image = frames_[k % 2];
// +    tzc::sensor_msgs::Image& image = frames_[k % 2];
// -    sensor_msgs::ImagePtr next(new sensor_msgs::Image(std::move(image)));
// +    tzc::sensor_msgs::ImagePtr next(new tzc::sensor_msgs::Image(std::move(image)));
// -  ros::Publisher pub_;
// -  sensor_msgs::Image frame_, other_, frames_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image frame_, other_, frames_[2];
