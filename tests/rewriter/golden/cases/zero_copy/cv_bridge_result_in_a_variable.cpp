// The image that cv_bridge returns becomes a variable: it is moved there, since nobody else has a pointer to it.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  void named(const cv::Mat& mat) {
    sensor_msgs::Image image = *cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
    image.header.frame_id = "camera";
    pub_.publish(image);
  }
  void deduced(const cv::Mat& mat) {
    cv_bridge::CvImagePtr bridge(new cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat));
    auto image = *(bridge->toImageMsg());
    image.header.frame_id = "camera";
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};

int main() {
  Camera().named(cv::Mat());
  Camera().deduced(cv::Mat());
}
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image = *cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
// +    tzc::sensor_msgs::Image image = std::move(*tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), pub_));
// -    auto image = *(bridge->toImageMsg());
// +    auto image = std::move(*(tzc::cv_bridge::to_image_msg(*bridge, pub_)));
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
