// What stands between changes something else of the same type, by its own name, or only reads: the publisher is named.
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
 public:
  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)), current_(&pub_) {
    pubs_.push_back(std::make_shared<ros::Publisher>(pub_));
  }
  void other_member() {
    sensor_msgs::Image image;
    image.data.resize(101);
    last_ = current_;
    ++sent_;
    current_->publish(image);
  }
  void other_number(std::size_t i) {
    sensor_msgs::Image image;
    image.data.resize(102);
    int counts[3] = {};
    counts[1] = 4;
    for (int k = 0; k < 3; ++k) image.width += counts[k];
    raw_[i]->publish(image);
  }
  void elements_read(std::size_t i) {
    sensor_msgs::Image image;
    image.data.resize(103);
    std::shared_ptr<ros::Publisher> copy = pubs_[i];
    pubs_[i]->publish(image);
  }
  void elements_of_message(std::size_t i) {
    sensor_msgs::Image image;
    image.data.resize(104);
    unsigned char* bytes = image.data.data();
    bytes[0] = 1;
    pubs_[i]->publish(image);
  }
  void asked_first(std::size_t i) {
    if (pubs_[i]->getNumSubscribers() == 0) return;
    sensor_msgs::Image image;
    image.data.resize(105);
    if (image.data[0] == 0) pubs_[i]->publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Publisher* current_;
  ros::Publisher* last_ = nullptr;
  ros::Publisher* raw_[2] = {&pub_, &pub_};
  std::vector<std::shared_ptr<ros::Publisher>> pubs_;
  int sent_ = 0;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:44 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)), current_(&pub_) {
// -    pubs_.push_back(std::make_shared<ros::Publisher>(pub_));
// +  Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)), current_(&pub_) {
// +    pubs_.push_back(std::make_shared<tzc::Publisher>(pub_));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    current_->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    raw_[i]->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[i]->allocate(image);
// -    std::shared_ptr<ros::Publisher> copy = pubs_[i];
// +    std::shared_ptr<tzc::Publisher> copy = pubs_[i];
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[i]->allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[i]->allocate(image);
// -  ros::Publisher pub_;
// -  ros::Publisher* current_;
// -  ros::Publisher* last_ = nullptr;
// -  ros::Publisher* raw_[2] = {&pub_, &pub_};
// -  std::vector<std::shared_ptr<ros::Publisher>> pubs_;
// +  tzc::Publisher pub_;
// +  tzc::Publisher* current_;
// +  tzc::Publisher* last_ = nullptr;
// +  tzc::Publisher* raw_[2] = {&pub_, &pub_};
// +  std::vector<std::shared_ptr<tzc::Publisher>> pubs_;
