// What is ported is not left out any more.
//RUN: level=plain except=image
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

tzc::Publisher pub;

void on_image(const sensor_msgs::ImageConstPtr&) {
  tzc::sensor_msgs::Image image;
  pub.allocate(image);
  image.data.resize(10);
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1, 0);
  ros::Subscriber sub = tzc::subscribe(nh, "image", 1, on_image);
}
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// subscribe src/node.cpp:20 sensor_msgs/Image shared 'image'
