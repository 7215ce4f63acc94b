// publish takes a pointer to a const message: the member's pointer is converted.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : it_(nh_) {
    pub_ = it_.advertise("image", 1);
    image_ = boost::make_shared<sensor_msgs::Image>();
  }
  void publish(int k) {
    image_->data.resize(700);
    image_->data[k % 700] = static_cast<uint8_t>(k);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  image_transport::ImageTransport it_;
  image_transport::Publisher pub_;
  sensor_msgs::ImagePtr image_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1022 line 14 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = it_.advertise("image", 1);
// -    image_ = boost::make_shared<sensor_msgs::Image>();
// +    pub_ = tzc::image_transport::advertise(it_, "image", 1);
// +    image_ = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub_.allocate(*image_);
// -  image_transport::Publisher pub_;
// -  sensor_msgs::ImagePtr image_;
// +  tzc::image_transport::Publisher pub_;
// +  tzc::sensor_msgs::ImagePtr image_;
