// A method of another class builds the message; a pointer to the publisher is at hand.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

class Converter {
 public:
  // publisher: never seen here before
  sensor_msgs::PointCloud2Ptr convert(unsigned points) const {
    sensor_msgs::PointCloud2Ptr cloud(new sensor_msgs::PointCloud2);
    cloud->data.resize(points * 16);
    return cloud;
  }
};

class Driver {
 public:
  explicit Driver(ros::NodeHandle& nh) : pub_(new ros::Publisher(nh.advertise<sensor_msgs::PointCloud2>("points", 10))) {}
  void poll() { pub_->publish(converter_.convert(100)); }

 private:
  Converter converter_;
  boost::shared_ptr<ros::Publisher> pub_;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
// publish src/node.cpp:18 sensor_msgs/PointCloud2 zero_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  sensor_msgs::PointCloud2Ptr convert(unsigned points) const {
// -    sensor_msgs::PointCloud2Ptr cloud(new sensor_msgs::PointCloud2);
// +  tzc::sensor_msgs::PointCloud2Ptr convert(const tzc::Publisher& publisher, unsigned points) const {
// +    tzc::sensor_msgs::PointCloud2Ptr cloud(new tzc::sensor_msgs::PointCloud2);
// +    publisher.allocate(*cloud);
// -  explicit Driver(ros::NodeHandle& nh) : pub_(new ros::Publisher(nh.advertise<sensor_msgs::PointCloud2>("points", 10))) {}
// -  void poll() { pub_->publish(converter_.convert(100)); }
// +  explicit Driver(ros::NodeHandle& nh) : pub_(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "points", 10))) {}
// +  void poll() { pub_->publish(converter_.convert(*pub_, 100)); }
// -  boost::shared_ptr<ros::Publisher> pub_;
// +  boost::shared_ptr<tzc::Publisher> pub_;
