// A structured binding that refers to an object: its message is built anew for each publish.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int count = 0;
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("anew", 1)) {}
  void send() {
    auto& [image, count] = frame_;
    image.data.assign(5000, count++);
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
  Frame frame_;
};

void run(ros::NodeHandle& nh) {
  Node node(nh);
  while (ros::ok()) node.send();
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'anew'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'anew'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("anew", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "anew", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
