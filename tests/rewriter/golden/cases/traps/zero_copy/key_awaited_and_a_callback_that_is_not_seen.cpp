// What runs in cv::waitKey is not seen.
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <mutex>

void (*callback)(int, void*) = nullptr;

class Viewer {
 public:
  void open(ros::NodeHandle& nh) {
    cv::createTrackbar("low", "window", nullptr, 10, callback);
    std::lock_guard<std::mutex> lock(mutex_);
    images_ = image_transport::ImageTransport(nh).advertise("image", 1);
    clouds_ = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
  }
  void show(const std_msgs::Header& header, const cv::Mat& picture) {
    if (is_shown_) cv::waitKey(1);
    images_.publish(cv_bridge::CvImage(header, "mono8", picture).toImageMsg());
  }
  void step(int bytes) {
    sensor_msgs::PointCloud2 cloud;
    if (is_shown_) cv::waitKey(1);
    cloud.data.resize(bytes);
    clouds_.publish(cloud);
  }

 private:
  std::mutex mutex_;
  image_transport::Publisher images_;
  ros::Publisher clouds_;
  bool is_shown_ = false;
};
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:16 sensor_msgs/PointCloud2 zero_copy 'cloud'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:26 sensor_msgs/PointCloud2 zero_copy 'cloud'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    images_ = image_transport::ImageTransport(nh).advertise("image", 1);
// -    clouds_ = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
// +    images_ = tzc::image_transport::advertise(image_transport::ImageTransport(nh), "image", 1);
// +    clouds_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "cloud", 1);
// -    images_.publish(cv_bridge::CvImage(header, "mono8", picture).toImageMsg());
// +    images_.publish(tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(header, "mono8", picture), images_));
// -    sensor_msgs::PointCloud2 cloud;
// +    tzc::sensor_msgs::PointCloud2 cloud;
// +    tzc::allocate(cloud);
// -  image_transport::Publisher images_;
// -  ros::Publisher clouds_;
// +  tzc::image_transport::Publisher images_;
// +  tzc::Publisher clouds_;
