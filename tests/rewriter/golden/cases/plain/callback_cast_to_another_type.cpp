// What a function does with a message that it is given by a cast of its pointer, its own type tells: here it takes it as its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

void writes(const sensor_msgs::ImagePtr& image) {
  image->data.resize(5);
}

void grow(sensor_msgs::PointCloud2& cloud) {
  cloud.data.resize(5);
}

typedef void (*Reads)(const sensor_msgs::PointCloud2&);

void cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  Reads reads = (Reads)grow;
  reads(*cloud);
}

struct Node {
  void on(const sensor_msgs::LaserScanPtr& scan) { scan->ranges.resize(5); }
};

void run(ros::NodeHandle& nh, Node& node) {
  ros::Subscriber a = nh.subscribe("a", 1, (void (*)(const sensor_msgs::ImageConstPtr&))writes);
  ros::Subscriber b = nh.subscribe("b", 1, cloud);
  ros::Subscriber c =
      nh.subscribe("c", 1, reinterpret_cast<void (Node::*)(const sensor_msgs::LaserScanConstPtr&)>(&Node::on), &node);
}
//--- expected
// subscribe src/node.cpp:27 sensor_msgs/Image plain 'a' TZC2002 a function that is cast to another type may be given this message, and write to it
// subscribe src/node.cpp:28 sensor_msgs/PointCloud2 plain 'b' TZC2002 a function that is cast to another type may be given this message, and write to it
// subscribe src/node.cpp:30 sensor_msgs/LaserScan plain 'c' TZC2002 a function that is cast to another type may be given this message, and write to it
