// An event that is made of a received one copies the message before it gives it out to be written to, unless it is told otherwise.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include <utility>

void image(const ros::MessageEvent<sensor_msgs::Image const>& event) {
  ros::MessageEvent<sensor_msgs::Image> mine(event);
  mine.getMessage()->data.resize(5);
}

void scan(const ros::MessageEvent<sensor_msgs::LaserScan const>& event) {
  bool is_shown = false;
  ros::MessageEvent<sensor_msgs::LaserScan> copied(event, true);
  ros::MessageEvent<sensor_msgs::LaserScan> mine(event, is_shown || event.nonConstWillCopy());
  mine.getMessage()->ranges.resize(5);
  std::pair<int, ros::MessageEvent<sensor_msgs::LaserScan const>> numbered = std::make_pair(0, event);
}

void run(ros::NodeHandle& nh) {
  ros::Subscriber a = nh.subscribe("a", 1, image);
  ros::Subscriber b = nh.subscribe("b", 1, scan);
}
//--- expected
// subscribe src/node.cpp:22 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:23 sensor_msgs/LaserScan shared 'b'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe("a", 1, image);
// -  ros::Subscriber b = nh.subscribe("b", 1, scan);
// +  ros::Subscriber a = tzc::subscribe(nh, "a", 1, image);
// +  ros::Subscriber b = tzc::subscribe(nh, "b", 1, scan);
