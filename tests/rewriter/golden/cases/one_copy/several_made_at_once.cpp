// allocate takes one message, and a pointer to an array does not lead to one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

void owned(int size) {
  std::unique_ptr<sensor_msgs::Image[]> images(new sensor_msgs::Image[2]);
  images[0].data.resize(size);
  images[1].data.resize(size);
  pub.publish(images[0]);
  pub.publish(images[1]);
}
void made(int size) {
  auto images = std::make_unique<sensor_msgs::Image[]>(2);
  images[1].data.resize(size);
  pub.publish(images[1]);
}
void raw(int size) {
  sensor_msgs::Image* images = new sensor_msgs::Image[2];
  images[1].data.resize(size);
  pub.publish(images[1]);
  delete[] images;
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  owned(100);
  made(100);
  raw(100);
}
//--- expected
