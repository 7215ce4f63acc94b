// More messages in a local array than should have a statement each, and such as start with copies.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void many() {
    sensor_msgs::Image images[16];
    for (int i = 0; i < 16; ++i) {
      images[i].data.resize(6000);
      many_pub_.publish(images[i]);
    }
  }
  void copies() {
    sensor_msgs::Image images[2] = {background_, background_};
    for (int i = 0; i < 2; ++i) {
      images[i].data[0] = i;
      copies_pub_.publish(images[i]);
    }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher many_pub_ = nh_.advertise<sensor_msgs::Image>("many", 1);
  ros::Publisher copies_pub_ = nh_.advertise<sensor_msgs::Image>("copies", 1);
  sensor_msgs::Image background_;
};
//--- expected
