// A base class of another package advertises: shared memory is attached to what it returns.
#include <other/library.h>
#include <sensor_msgs/Imu.h>

class Child : public other::Nodelet {
 public:
  explicit Child(ros::NodeHandle& nh) : nh_(nh), points_(advertise<sensor_msgs::PointCloud2>(nh, "points", 1)) {
    images_ = this->advertise<sensor_msgs::Image>(nh_, "image", 1, true);
    imu_ = advertise<sensor_msgs::Imu>(nh_, "imu", 1);
  }
  void poll() {
    sensor_msgs::Image image;
    image.data.resize(10);
    images_.publish(image);
    sensor_msgs::PointCloud2Ptr points(new sensor_msgs::PointCloud2);
    points->data.resize(10);
    points_.publish(points);
    imu_.publish(sensor_msgs::Imu());
  }

 private:
  ros::NodeHandle& nh_;
  ros::Publisher images_, points_, imu_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/PointCloud2 zero_copy 'points'
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:9 sensor_msgs/Imu not_needed 'imu'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
// publish src/node.cpp:18 sensor_msgs/Imu not_needed 'imu'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  explicit Child(ros::NodeHandle& nh) : nh_(nh), points_(advertise<sensor_msgs::PointCloud2>(nh, "points", 1)) {
// -    images_ = this->advertise<sensor_msgs::Image>(nh_, "image", 1, true);
// +  explicit Child(ros::NodeHandle& nh) : nh_(nh), points_(tzc::attach_publisher<tzc::sensor_msgs::PointCloud2>(advertise<sensor_msgs::PointCloud2>(nh, "points", 1))) {
// +    images_ = tzc::attach_publisher<tzc::sensor_msgs::Image>(this->advertise<sensor_msgs::Image>(nh_, "image", 1, true));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    images_.allocate(image);
// -    sensor_msgs::PointCloud2Ptr points(new sensor_msgs::PointCloud2);
// +    tzc::sensor_msgs::PointCloud2Ptr points(new tzc::sensor_msgs::PointCloud2);
// +    points_.allocate(*points);
// -  ros::Publisher images_, points_, imu_;
// +  tzc::Publisher images_, points_;
// +  ros::Publisher imu_;
