// A base class advertises for its children, whatever their type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/PointCloud2.h>

class Base {
 protected:
  template <class T>
  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic, int queue) {
    ros::Publisher pub = nh.advertise<T>(topic, queue, ros::SubscriberStatusCallback());
    publishers_.push_back(pub);
    return pub;
  }
  std::vector<ros::Publisher> publishers_;
};

class Child : public Base {
 public:
  explicit Child(ros::NodeHandle& nh)
      : images_(advertise<sensor_msgs::Image>(nh, "image", 1)),
        points_(advertise<sensor_msgs::PointCloud2>(nh, "points", 1)),
        imu_(advertise<sensor_msgs::Imu>(nh, "imu", 1)) {}
  void poll() {
    sensor_msgs::Image image;
    image.data.resize(10);
    images_.publish(image);
    sensor_msgs::PointCloud2 points;
    points.data.resize(10);
    points_.publish(points);
    imu_.publish(sensor_msgs::Imu());
  }

 private:
  ros::Publisher images_, points_, imu_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image zero_copy
// advertise src/node.cpp:11 sensor_msgs/Imu not_needed
// advertise src/node.cpp:11 sensor_msgs/PointCloud2 zero_copy
// publish src/node.cpp:27 sensor_msgs/Image zero_copy
// publish src/node.cpp:30 sensor_msgs/PointCloud2 zero_copy
// publish src/node.cpp:31 sensor_msgs/Imu not_needed
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher advertise(ros::NodeHandle& nh, const std::string& topic, int queue) {
// -    ros::Publisher pub = nh.advertise<T>(topic, queue, ros::SubscriberStatusCallback());
// +  tzc::Publisher advertise(ros::NodeHandle& nh, const std::string& topic, int queue) {
// +    tzc::Publisher pub = tzc::advertise<T>(nh, topic, queue, ros::SubscriberStatusCallback());
// -  std::vector<ros::Publisher> publishers_;
// +  std::vector<tzc::Publisher> publishers_;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    images_.allocate(image);
// -    sensor_msgs::PointCloud2 points;
// +    tzc::sensor_msgs::PointCloud2 points;
// +    points_.allocate(points);
// -  ros::Publisher images_, points_, imu_;
// +  tzc::Publisher images_, points_, imu_;
