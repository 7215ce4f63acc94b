// The calibration that goes out with an image is given a vector's elements each time, and written after the publish: a few numbers.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <vector>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertiseCamera("image_raw", 1)) {}
  void tick(unsigned n) {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(n);
    info_.D = std::vector<double>(5, 0.1);
    pub_.publish(*image, info_);
    info_.D[0] = 0.2;
  }

 private:
  image_transport::ImageTransport it_;
  image_transport::CameraPublisher pub_;
  sensor_msgs::CameraInfo info_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'image_raw'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image_raw'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertiseCamera("image_raw", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(tzc::image_transport::advertiseCamera(it_, "image_raw", 1)) {}
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -  image_transport::CameraPublisher pub_;
// +  tzc::image_transport::CameraPublisher pub_;
