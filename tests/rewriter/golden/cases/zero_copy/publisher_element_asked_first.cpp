// Whether a sequence has the element is asked behind the message: find_publisher() may be asked at any time.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <array>
#include <deque>
#include <map>

class Node {
 public:
  Node() : outs_{} {
    pubs_.push_back(nh_.advertise<sensor_msgs::Image>("vector", 1));
    queue_.push_back(nh_.advertise<sensor_msgs::Image>("deque", 1));
    outs_[0] = nh_.advertise<sensor_msgs::Image>("array", 1);
    pair_[1] = nh_.advertise<sensor_msgs::Image>("pair", 1);
    named_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1);
  }
  void first(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (pubs_.empty()) return;
    pubs_.front().publish(image);
  }
  void last(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (!queue_.empty()) queue_.back().publish(image);
  }
  void checked(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    this->pubs_.at(n).publish(image);
  }
  void chosen(int n) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (n >= 0) outs_[n].publish(image);
  }
  void other(bool second) {
    sensor_msgs::Image image;
    image.data.resize(100);
    if (second) pair_[1].publish(image);
  }
  void by_name(const std::string& name) {
    sensor_msgs::Image image;
    image.data.resize(100);
    named_.at(name).publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> pubs_;
  std::deque<ros::Publisher> queue_;
  ros::Publisher outs_[2];
  std::array<ros::Publisher, 2> pair_;
  std::map<std::string, ros::Publisher> named_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'vector'
// advertise src/node.cpp:13 sensor_msgs/Image zero_copy 'deque'
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'array'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'pair'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'left'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'vector'
// publish src/node.cpp:27 sensor_msgs/Image zero_copy 'deque'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'vector'
// publish src/node.cpp:37 sensor_msgs/Image zero_copy 'array'
// publish src/node.cpp:42 sensor_msgs/Image zero_copy 'pair'
// publish src/node.cpp:47 sensor_msgs/Image zero_copy 'left'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_.push_back(nh_.advertise<sensor_msgs::Image>("vector", 1));
// -    queue_.push_back(nh_.advertise<sensor_msgs::Image>("deque", 1));
// -    outs_[0] = nh_.advertise<sensor_msgs::Image>("array", 1);
// -    pair_[1] = nh_.advertise<sensor_msgs::Image>("pair", 1);
// -    named_["left"] = nh_.advertise<sensor_msgs::Image>("left", 1);
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "vector", 1));
// +    queue_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "deque", 1));
// +    outs_[0] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "array", 1);
// +    pair_[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "pair", 1);
// +    named_["left"] = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pubs_, 0).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(queue_, queue_.size() - 1).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(this->pubs_, n).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(outs_, n).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(pair_, 1).allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::find_publisher(named_, name).allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// -  std::deque<ros::Publisher> queue_;
// -  ros::Publisher outs_[2];
// -  std::array<ros::Publisher, 2> pair_;
// -  std::map<std::string, ros::Publisher> named_;
// +  std::vector<tzc::Publisher> pubs_;
// +  std::deque<tzc::Publisher> queue_;
// +  tzc::Publisher outs_[2];
// +  std::array<tzc::Publisher, 2> pair_;
// +  std::map<std::string, tzc::Publisher> named_;
