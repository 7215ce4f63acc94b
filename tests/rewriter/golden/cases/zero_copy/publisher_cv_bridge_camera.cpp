// cv_bridge through an image_transport publisher.
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise("image", 1)) {}
  void publish(const cv_bridge::CvImagePtr& image) { pub_.publish(image->toImageMsg()); }

 private:
  image_transport::ImageTransport it_;
  image_transport::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// -  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise("image", 1)) {}
// -  void publish(const cv_bridge::CvImagePtr& image) { pub_.publish(image->toImageMsg()); }
// +  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(tzc::image_transport::advertise(it_, "image", 1)) {}
// +  void publish(const cv_bridge::CvImagePtr& image) { pub_.publish(tzc::cv_bridge::to_image_msg(*image, pub_)); }
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
