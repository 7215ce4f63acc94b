// What another package's function does with the message is not known.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <other/tracker.h>

int main() {
  ros::NodeHandle nh;
  other::Tracker tracker;
  ros::Subscriber sub = nh.subscribe("image", 1, &other::Tracker::on_image, &tracker);
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image copied 'image' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber sub = nh.subscribe("image", 1, &other::Tracker::on_image, &tracker);
// +  ros::Subscriber sub = tzc::subscribe(nh, "image", 1, &other::Tracker::on_image, &tracker);
