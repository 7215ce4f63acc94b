// Macros for what is published, for its size and for what fills it.
//RUN: on-exhausted=drop
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>

#define TOPIC "image"
#define QUEUE 1
#define SIZE (10 * 10)
#define MESSAGE image
#define ENCODING "mono8"

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise(TOPIC, QUEUE)) {}
  void local() {
    sensor_msgs::Image image;
    image.width = SIZE;
    image.data.resize(SIZE);
    pub_.publish(MESSAGE);
  }
  void held() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(SIZE);
    pub_.publish(MESSAGE);
  }
  void filled(const cv_bridge::CvImage& from) {
    sensor_msgs::Image image;
    from.toImageMsg(MESSAGE);
    pub_.publish(MESSAGE);
  }
  void made(const cv::Mat& mat) {
    pub_.publish(cv_bridge::CvImage(std_msgs::Header(), ENCODING, mat).toImageMsg());
  }

 private:
  image_transport::ImageTransport it_;
  image_transport::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(it_.advertise(TOPIC, QUEUE)) {}
// +  explicit Node(ros::NodeHandle& nh) : it_(nh), pub_(tzc::image_transport::advertise(it_, TOPIC, QUEUE)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    pub_.publish(MESSAGE);
// +    if (pub_.allocate(MESSAGE)) pub_.publish(MESSAGE);
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -    pub_.publish(MESSAGE);
// +    if (pub_.allocate(*MESSAGE)) pub_.publish(MESSAGE);
// -    sensor_msgs::Image image;
// -    from.toImageMsg(MESSAGE);
// -    pub_.publish(MESSAGE);
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// +    tzc::cv_bridge::to_image_msg(from, MESSAGE);
// +    if (pub_.allocate(MESSAGE)) pub_.publish(MESSAGE);
// -    pub_.publish(cv_bridge::CvImage(std_msgs::Header(), ENCODING, mat).toImageMsg());
// +    pub_.publish(tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), ENCODING, mat), pub_));
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
