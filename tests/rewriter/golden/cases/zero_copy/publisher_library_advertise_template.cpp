// A template of the package has the library advertise: the type stays the parameter.
#include <other/library.h>

class Base : public other::Nodelet {
 protected:
  template <class T>
  ros::Publisher advertise_latched(ros::NodeHandle& nh, const std::string& topic) {
    return advertise<T>(nh, topic, 1, true);
  }
};

class Child : public Base {
 public:
  explicit Child(ros::NodeHandle& nh) {
    images_ = advertise_latched<sensor_msgs::Image>(nh, "image");
    points_ = advertise_latched<sensor_msgs::PointCloud2>(nh, "points");
  }
  void poll() {
    sensor_msgs::Image image;
    image.data.resize(10);
    images_.publish(image);
    sensor_msgs::PointCloud2 points;
    points.data.resize(10);
    points_.publish(points);
  }

 private:
  ros::Publisher images_, points_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy
// advertise src/node.cpp:8 sensor_msgs/PointCloud2 zero_copy
// publish src/node.cpp:21 sensor_msgs/Image zero_copy
// publish src/node.cpp:24 sensor_msgs/PointCloud2 zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -  ros::Publisher advertise_latched(ros::NodeHandle& nh, const std::string& topic) {
// -    return advertise<T>(nh, topic, 1, true);
// +  tzc::Publisher advertise_latched(ros::NodeHandle& nh, const std::string& topic) {
// +    return tzc::attach_publisher<T>(advertise<T>(nh, topic, 1, true));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    images_.allocate(image);
// -    sensor_msgs::PointCloud2 points;
// +    tzc::sensor_msgs::PointCloud2 points;
// +    points_.allocate(points);
// -  ros::Publisher images_, points_;
// +  tzc::Publisher images_, points_;
