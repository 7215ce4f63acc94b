// image_transport::Publisher.
#include <image_transport/image_transport.h>

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise("image", 1)) {}
  void publish() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(1);
    pub_.publish(image);
    sensor_msgs::Image local;
    local.data.resize(1);
    pub_.publish(local);
  }

 private:
  image_transport::ImageTransport it_;
  image_transport::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise("image", 1)) {}
// +  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(tzc::image_transport::advertise(it_, "image", 1)) {}
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -    sensor_msgs::Image local;
// +    tzc::sensor_msgs::Image local;
// +    pub_.allocate(local);
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
