// A pointer to a publisher that may be set by a call in between: it can't be followed where the message is born.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <functional>

struct Output {
  ros::Publisher publisher;
};

class Node {
 public:
  void by_callback(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    ros::spinOnce();
    output_->publisher.publish(image);
  }
  void by_function(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    choose_();
    output_->publisher.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  Output left_{nh_.advertise<sensor_msgs::Image>("image", 1)};
  Output* output_ = nullptr;
  std::function<void()> choose_ = [this] { output_ = &left_; };
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher publisher;
// +  tzc::Publisher publisher;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -  Output left_{nh_.advertise<sensor_msgs::Image>("image", 1)};
// +  Output left_{tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)};
