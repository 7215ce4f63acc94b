// The message was not published on each way to the copy, or has been written to since: the copy has elements of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void perhaps(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    if (count > 7) pub_.publish(image);
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void written(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    image.data[0] = 2;
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void by_another_name(int count) {
    sensor_msgs::Image image;
    sensor_msgs::Image& name = image;
    image.data.assign(count, 1);
    pub_.publish(image);
    name.data[0] = 2;
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void in_a_loop(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    for (int i = 0; i < 3; ++i) {
      const sensor_msgs::Image again = image;
      copy_pub_.publish(again);
      image.data[i] = 3;
    }
  }
  void jumped_over(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    if (count > 7) goto copy;
    pub_.publish(image);
  copy : {
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
};
//--- expected
