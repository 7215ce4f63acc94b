// A function of a library that nobody knows may wait for the thread that fills the message: nothing in front of it may touch the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <semaphore.h>

class Node {
 public:
  void step() {
    image_.header.stamp = ros::Time::now();
    sem_wait(&filled_);
    image_.data[0] = 1;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  sem_t filled_;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:17 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::Image image_;
