// what() of an exception of the package publishes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <exception>
#include <string>

class Node;
struct Failure : std::exception {
  explicit Failure(Node& node) : node(node) {}
  const char* what() const noexcept override;
  Node& node;
};

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void send() { pub_.publish(image_); }
  void publish(const std::exception& problem) {
    image_.data.resize(100);
    uint8_t* first = &image_.data[0];
    problem_ = problem.what();
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  std::string problem_;
};

const char* Failure::what() const noexcept {
  node.send();
  return "";
}
//--- expected
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
