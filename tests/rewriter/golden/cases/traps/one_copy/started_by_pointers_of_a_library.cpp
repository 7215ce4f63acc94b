// A library makes the objects, each of which starts with a message: nothing shows how many there are.
#include <map>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
};

class Node {
 public:
  void resized() {
    frames_.emplace_back();
    frames_.back().image->data.assign(6000, 1);
    pub_.publish(frames_.back().image);
  }
  void found(int n) {
    by_number_[n].image->data.assign(6000, 1);
    pub_.publish(by_number_[n].image);
  }
  void of_thread() {
    thread_local sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
    image->data.assign(6000, 1);
    threads_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher threads_pub_ = nh_.advertise<sensor_msgs::Image>("thread", 1);
  std::vector<Frame> frames_;
  std::map<int, Frame> by_number_;
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1019 it has no name where it is built
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1019 it has no name where it is built
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'thread' TZC1019 each thread makes one, where it is declared
// advertise src/node.cpp:30 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'thread'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher threads_pub_ = nh_.advertise<sensor_msgs::Image>("thread", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher threads_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "thread", 1);
