// The pointer is declared first and gets its image in a branch.
#include <cv_bridge/cv_bridge.h>
#include <image_transport/image_transport.h>
#include <ros/ros.h>

class Camera {
 public:
  explicit Camera(ros::NodeHandle& nh) {
    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
  }

  void publish(const cv::Mat& frame) {
    sensor_msgs::ImagePtr msg;
    std_msgs::Header header;
    if (!frame.empty()) {
      cv_bridge::CvImagePtr image = boost::make_shared<cv_bridge::CvImage>(header, "bgr8", frame);
      msg = image->toImageMsg();
      pub_.publish(*msg);
    }
  }

 private:
  image_transport::Publisher pub_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera");
  ros::NodeHandle nh;
  Camera camera(nh);
  camera.publish(cv::Mat());
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/image_transport.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = image_transport::ImageTransport(nh).advertise("image", 1);
// +    pub_ = tzc::image_transport::advertise(image_transport::ImageTransport(nh), "image", 1);
// -    sensor_msgs::ImagePtr msg;
// +    tzc::sensor_msgs::ImagePtr msg;
// -      msg = image->toImageMsg();
// +      msg = tzc::cv_bridge::to_image_msg(*image, pub_);
// -  image_transport::Publisher pub_;
// +  tzc::image_transport::Publisher pub_;
