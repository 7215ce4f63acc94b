// image_transport::CameraPublisher: the image is ported, the small CameraInfo is not.
#include <image_transport/image_transport.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(new image_transport::ImageTransport(nh)) {
    pub_ = it_->advertiseCamera("image_raw", 1);
  }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(1);
    sensor_msgs::CameraInfo info;
    info.D.resize(5);
    pub_.publish(image, info);
  }

 private:
  boost::shared_ptr<image_transport::ImageTransport> it_;
  image_transport::CameraPublisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image_raw'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image_raw'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = it_->advertiseCamera("image_raw", 1);
// +    pub_ = tzc::image_transport::advertiseCamera(*it_, "image_raw", 1);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  image_transport::CameraPublisher pub_;
// +  tzc::image_transport::CameraPublisher pub_;
