// In a function that an initializer calls.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : first_(start()), pub_(nh_.advertise<sensor_msgs::Image>("image", 10)) { pub_.publish(first_); }
  sensor_msgs::Image start() { return make(); }
  sensor_msgs::Image make() {
    sensor_msgs::Image image;
    image.data.resize(10);
    return image;
  }

 private:
  ros::NodeHandle nh_;
  sensor_msgs::Image first_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:7 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub_' may not be there yet
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() : first_(start()), pub_(nh_.advertise<sensor_msgs::Image>("image", 10)) { pub_.publish(first_); }
// +  Node() : first_(start()), pub_(tzc::advertise<sensor_msgs::Image>(nh_, "image", 10)) { pub_.publish(first_); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
