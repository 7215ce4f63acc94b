// Functions of the same libraries that may throw, and one of the package in a library's namespace.
#include <angles/angles.h>
#include <cv_bridge/cv_bridge.h>
#include <pcl/point_cloud.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <stdexcept>

namespace angles {
double checked(double angle) {
  if (angle > 7) throw std::out_of_range("angle");
  return angle;
}
}  // namespace angles

struct Output {
  ros::Publisher publisher;
};

class Node {
 public:
  explicit Node(Output* output) : output_(output) {
    output_->publisher = nh_.advertise<sensor_msgs::Image>("image", 1);
  }
  void by_angle(double angle) {
    sensor_msgs::Image image;
    image.data.resize(angles::checked(angle) < 1 ? 10 : 20);
    output_->publisher.publish(image);
  }
  void by_picture(cv::Mat& picture) {
    sensor_msgs::Image image;
    image.data.resize(30);
    cv::flip(picture, picture, 0);
    output_->publisher.publish(image);
  }
  void by_cloud(const pcl::PointCloud<pcl::PointXYZ>& cloud) {
    sensor_msgs::Image image;
    image.data.resize(cloud.at(0).x);
    output_->publisher.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  Output* output_;
};
//--- expected
// advertise src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher publisher;
// +  tzc::Publisher publisher;
// -    output_->publisher = nh_.advertise<sensor_msgs::Image>("image", 1);
// +    output_->publisher = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
