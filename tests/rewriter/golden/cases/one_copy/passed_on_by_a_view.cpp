// Member functions of views that give the pointer to another object, or to a function.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void assigned() {
    sensor_msgs::Image image;
    image.data.resize(100);
    cv::Mat mat(10, 10, 0, image.data.data()), canvas;
    mat.assignTo(canvas);
    pub_.publish(image);
    canvas.data[0] = 0;
  }
  void swapped() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::pair<uint8_t*, size_t> buffer(image.data.data(), 100);
    buffer.swap(last_);
    second_pub_.publish(image);
    last_.first[0] = 0;
  }
  void called() {
    sensor_msgs::Image image;
    image.data.resize(100);
    cv::Mat mat(10, 10, 0, image.data.data());
    mat.forEach<uint8_t>([this](uint8_t& pixel, const int*) { pixel_ = &pixel; });
    third_pub_.publish(image);
    *pixel_ = 0;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
  std::pair<uint8_t*, size_t> last_;
  uint8_t* pixel_ = nullptr;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy '1' TZC1003 a pointer into its data is passed to 'cv::Mat::assignTo'
// publish src/node.cpp:21 sensor_msgs/Image one_copy '2' TZC1003 a pointer into its data is passed to 'std::pair::swap'
// publish src/node.cpp:29 sensor_msgs/Image one_copy '3' TZC1003 a pointer into its data is kept in 'pixel_'
// advertise src/node.cpp:35 sensor_msgs/Image one_copy '1'
// advertise src/node.cpp:36 sensor_msgs/Image one_copy '2'
// advertise src/node.cpp:37 sensor_msgs/Image one_copy '3'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("1", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("2", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("3", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "1", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "2", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "3", 1);
