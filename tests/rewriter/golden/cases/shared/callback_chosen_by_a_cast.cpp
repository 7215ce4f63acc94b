// A cast that only says which function of a name is meant, or whose member it is, changes nothing that it does.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

void on(const sensor_msgs::ImageConstPtr&) {}
void on(int) {}

struct Base {
  virtual ~Base() = default;
};

struct Node : Base {
  void on(const sensor_msgs::LaserScanConstPtr&) {}
  void on(int) {}
};

void run(ros::NodeHandle& nh, Node& node) {
  ros::Subscriber a = nh.subscribe("a", 1, (void (*)(const sensor_msgs::ImageConstPtr&))on);
  ros::Subscriber b =
      nh.subscribe("b", 1, static_cast<void (Node::*)(const sensor_msgs::LaserScanConstPtr&)>(&Node::on), &node);
}
//--- expected
// subscribe src/node.cpp:19 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:21 sensor_msgs/LaserScan shared 'b'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe("a", 1, (void (*)(const sensor_msgs::ImageConstPtr&))on);
// +  ros::Subscriber a = tzc::subscribe(nh, "a", 1, (void (*)(const sensor_msgs::ImageConstPtr&))on);
// -      nh.subscribe("b", 1, static_cast<void (Node::*)(const sensor_msgs::LaserScanConstPtr&)>(&Node::on), &node);
// +      tzc::subscribe(nh, "b", 1, static_cast<void (Node::*)(const sensor_msgs::LaserScanConstPtr&)>(&Node::on), &node);
