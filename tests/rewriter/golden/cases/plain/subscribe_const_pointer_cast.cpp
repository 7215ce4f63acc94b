// The callback casts const away from the pointer.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void callback(const sensor_msgs::ImageConstPtr& image) {
  sensor_msgs::ImagePtr writable = boost::const_pointer_cast<sensor_msgs::Image>(image);
  writable->data[0] = 1;
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber sub = nh.subscribe("image", 1, callback);
}
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it
