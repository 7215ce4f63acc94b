// A base class of another package advertises images through image_transport.
#include <cv_bridge/cv_bridge.h>
#include <other/image_library.h>

class Child : public other::ImageNodelet {
 public:
  explicit Child(ros::NodeHandle& nh) {
    images_ = advertiseImage(nh, "image", 1);
    camera_ = advertiseCamera(nh, "camera", 1);
  }
  void poll(const sensor_msgs::CameraInfo& info) {
    images_.publish(cv_bridge::CvImage().toImageMsg());
    sensor_msgs::Image image;
    image.data.resize(10);
    camera_.publish(image, info);
  }

 private:
  image_transport::Publisher images_;
  image_transport::CameraPublisher camera_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'camera'
// publish src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'camera'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    images_ = advertiseImage(nh, "image", 1);
// -    camera_ = advertiseCamera(nh, "camera", 1);
// +    images_ = tzc::image_transport::attach_publisher(advertiseImage(nh, "image", 1));
// +    camera_ = tzc::image_transport::attach_publisher(advertiseCamera(nh, "camera", 1));
// -    images_.publish(cv_bridge::CvImage().toImageMsg());
// -    sensor_msgs::Image image;
// +    images_.publish(tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(), images_));
// +    tzc::sensor_msgs::Image image;
// +    camera_.allocate(image);
// -  image_transport::Publisher images_;
// -  image_transport::CameraPublisher camera_;
// +  tzc::image_transport::Publisher images_;
// +  tzc::image_transport::CameraPublisher camera_;
