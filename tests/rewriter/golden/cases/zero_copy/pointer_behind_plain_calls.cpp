// What stands before a pointer to the publisher calculates or looks: it always comes back, and runs no code of the package.
#include <angles/angles.h>
#include <cv_bridge/cv_bridge.h>
#include <pcl/point_cloud.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

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
    image.data.resize(angles::normalize_angle(angle) < 1 ? 10 : 20);
    output_->publisher.publish(image);
  }
  void by_picture(const cv::Mat& picture) {
    sensor_msgs::Image image;
    image.step = picture.channels();
    image.data.resize(picture.empty() ? 0 : 30);
    output_->publisher.publish(image);
  }
  void by_cloud(const pcl::PointCloud<pcl::PointXYZ>& cloud) {
    sensor_msgs::Image image;
    image.data.resize(cloud.size());
    output_->publisher.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  Output* output_;
};
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
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
// +    output_->publisher.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    output_->publisher.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    output_->publisher.allocate(image);
