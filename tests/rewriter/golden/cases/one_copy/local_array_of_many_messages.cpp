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
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'many' TZC1019 it is an element of 'images', and nothing shows where that makes it
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'copies' TZC1022 its elements come from a message that is never published itself (copied into 'images' in line 15), and lie outside shared memory
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'many'
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'copies'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image images[2] = {background_, background_};
// +    tzc::sensor_msgs::Image images[2] = {background_, background_};
// -  ros::Publisher many_pub_ = nh_.advertise<sensor_msgs::Image>("many", 1);
// -  ros::Publisher copies_pub_ = nh_.advertise<sensor_msgs::Image>("copies", 1);
// -  sensor_msgs::Image background_;
// +  tzc::Publisher many_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "many", 1);
// +  tzc::Publisher copies_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "copies", 1);
// +  tzc::sensor_msgs::Image background_;
