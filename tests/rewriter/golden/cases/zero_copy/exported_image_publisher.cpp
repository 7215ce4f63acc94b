// Image publishers are members of an exported class.
#include <node/camera.h>

void Camera::tick(const cv::Mat& mat) {
  sensor_msgs::Image image;
  image.data.resize(640 * 480);
  image_.publish(image);

  sensor_msgs::ImagePtr shared(new sensor_msgs::Image);
  shared->data.resize(640 * 480);
  sensor_msgs::CameraInfoPtr info(new sensor_msgs::CameraInfo);
  camera_.publish(shared, info);

  sensor_msgs::Image stamped;
  stamped.data.resize(640 * 480);
  sensor_msgs::CameraInfo calibration;
  camera_.publish(stamped, calibration, ros::Time::now());

  mats_->publish(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg());
}
//--- include/node/camera.h
#pragma once
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>

#include <memory>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh)
      : transport_(nh),
        image_(transport_.advertise("image", 1)),
        camera_(transport_.advertiseCamera("camera/image", 1)),
        mats_(new image_transport::Publisher(transport_.advertise("mats", 1))) {}
  void tick(const cv::Mat& mat);

 protected:
  image_transport::ImageTransport transport_;
  image_transport::Publisher image_;
  image_transport::CameraPublisher camera_;
  std::unique_ptr<image_transport::Publisher> mats_;
};
//--- CMakeLists.txt
cmake_minimum_required(VERSION 3.5)
project(node)
find_package(catkin REQUIRED COMPONENTS roscpp sensor_msgs image_transport cv_bridge)
catkin_package(INCLUDE_DIRS include)
include_directories(include)
add_library(node src/node.cpp)
//--- expected
// advertise include/node/camera.h:11 sensor_msgs/Image zero_copy 'image'
// advertise include/node/camera.h:12 sensor_msgs/Image zero_copy 'camera/image'
// advertise include/node/camera.h:13 sensor_msgs/Image zero_copy 'mats'
// publish src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'camera/image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'camera/image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'mats'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  image_.publish(image);
// +  tzc::image_transport::publish(image_, image);
// -  sensor_msgs::ImagePtr shared(new sensor_msgs::Image);
// +  tzc::sensor_msgs::ImagePtr shared(new tzc::sensor_msgs::Image);
// +  tzc::allocate(*shared);
// -  camera_.publish(shared, info);
// +  tzc::image_transport::publish(camera_, shared, info);
// -  sensor_msgs::Image stamped;
// +  tzc::sensor_msgs::Image stamped;
// +  tzc::allocate(stamped);
// -  camera_.publish(stamped, calibration, ros::Time::now());
// +  tzc::image_transport::publish(camera_, stamped, calibration, ros::Time::now());
// -  mats_->publish(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg());
// +  tzc::image_transport::publish(*mats_, tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), tzc::Publisher()));
