// A structured binding that refers to an object is another name of its message, which keeps its content.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int count = 0;
};

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
  void send() {
    auto& [image, count] = frame_;
    if (image.data.empty()) image.data.resize(5000);
    image.data[count++ % 5000] = 1;
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
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'kept'
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'kept' TZC1022 line 16 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  explicit Node(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "kept", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
