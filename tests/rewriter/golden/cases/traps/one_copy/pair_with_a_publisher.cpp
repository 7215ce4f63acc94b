// A pair of a publisher and a message is ported as the publisher: nothing follows what happens to the message in it.
#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

class Stereo {
 public:
  Stereo() {
    left_.first = nh_.advertise<sensor_msgs::Image>("left", 1);
    left_.second.data.resize(640 * 480);
    view_ = cv::Mat(480, 640, 0, left_.second.data.data());
  }
  void tick() {
    view_.data[0] = ++count_;
    left_.first.publish(left_.second);
  }

 private:
  int count_ = 0;
  ros::NodeHandle nh_;
  std::pair<ros::Publisher, sensor_msgs::Image> left_;
  cv::Mat view_;
};

class Later {
 public:
  void put(const ros::Publisher& pub, const sensor_msgs::ImagePtr& image) { out_.push(std::make_pair(pub, image)); }
  void send() {
    out_.front().first.publish(out_.front().second);
    out_.pop();
  }
  void tick() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(6000);
    put(pub_, image);
    send();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("later", 1);
  std::queue<std::pair<ros::Publisher, sensor_msgs::ImagePtr>> out_;
};

class Headers {
 public:
  void tick() {
    sensor_msgs::Image image;
    image.header = pubs_["a"].second;
    image.data.resize(6000);
    pubs_["a"].first.publish(image);
  }
  void add() { pubs_["a"] = std::make_pair(nh_.advertise<sensor_msgs::Image>("headers", 1), std_msgs::Header()); }

 private:
  ros::NodeHandle nh_;
  std::map<std::string, std::pair<ros::Publisher, std_msgs::Header>> pubs_;
};

int main() {
  Stereo().tick();
  Later().tick();
  Headers headers;
  headers.add();
  headers.tick();
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'left'
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'left' TZC1001 it lies beside a publisher or filter in one pair or tuple
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'later' TZC1001 it lies beside a publisher or filter in one pair or tuple
// advertise src/node.cpp:48 sensor_msgs/Image one_copy 'later'
// publish src/node.cpp:58 sensor_msgs/Image zero_copy 'headers'
// advertise src/node.cpp:60 sensor_msgs/Image zero_copy 'headers'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// -    left_.first = nh_.advertise<sensor_msgs::Image>("left", 1);
// +    left_.first = tzc::advertise<sensor_msgs::Image>(nh_, "left", 1);
// -  std::pair<ros::Publisher, sensor_msgs::Image> left_;
// +  std::pair<tzc::Publisher, sensor_msgs::Image> left_;
// -  void put(const ros::Publisher& pub, const sensor_msgs::ImagePtr& image) { out_.push(std::make_pair(pub, image)); }
// +  void put(const tzc::Publisher& pub, const sensor_msgs::ImagePtr& image) { out_.push(std::make_pair(pub, image)); }
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("later", 1);
// -  std::queue<std::pair<ros::Publisher, sensor_msgs::ImagePtr>> out_;
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "later", 1);
// +  std::queue<std::pair<tzc::Publisher, sensor_msgs::ImagePtr>> out_;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  void add() { pubs_["a"] = std::make_pair(nh_.advertise<sensor_msgs::Image>("headers", 1), std_msgs::Header()); }
// +  void add() { pubs_["a"] = std::make_pair(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "headers", 1), std_msgs::Header()); }
// -  std::map<std::string, std::pair<ros::Publisher, std_msgs::Header>> pubs_;
// +  std::map<std::string, std::pair<tzc::Publisher, std_msgs::Header>> pubs_;
