// Objects that live as long as a call start with a message each time, whose only publish copies it; each holds the node.
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  ros::NodeHandle nh;
  sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
};
struct Listed {
  ros::NodeHandle nh;
  Listed() : image(new sensor_msgs::Image) {}
  std::unique_ptr<sensor_msgs::Image> image;
};
struct Around {
  Listed listed;
  int count = 0;
};

void by_default(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_default", 1);
  Frame frame;
  frame.image->data.resize(6000);
  pub.publish(*frame.image);
}
void by_braces(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_braces", 1);
  Frame frame{};
  frame.image->data.resize(6000);
  pub.publish(frame.image);
}
void on_heap(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("on_heap", 1);
  auto frame = std::make_shared<Frame>();
  frame->image->data.resize(6000);
  pub.publish(*frame->image);
}
void by_constructor(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_constructor", 1);
  Listed listed;
  listed.image->data.resize(6000);
  pub.publish(*listed.image);
}
void inside(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("inside", 1);
  const auto around = std::make_unique<Around>();
  around->listed.image->data.resize(6000);
  pub.publish(*around->listed.image);
}
//--- expected
// error does not parse: chosen constructor is explicit in copy-initialization
