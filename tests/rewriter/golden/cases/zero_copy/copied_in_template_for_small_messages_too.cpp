// One instance of the template makes a message that has nothing to allocate.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

template <class M>
void relay(const ros::Publisher& to, const M& in) {
  M out = in;
  to.publish(out);
}

int main() {
  ros::NodeHandle nh;
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher texts = nh.advertise<std_msgs::String>("text", 1);
  sensor_msgs::Image image;
  image.data.resize(100);
  relay(images, image);
  std_msgs::String text;
  relay(texts, text);
}
//--- expected
