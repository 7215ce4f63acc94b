// Calls in between that run no code of the package; and one that runs callbacks, which may throw before the pointer is followed.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Output {
  ros::Publisher publisher;
};

class Node {
 public:
  explicit Node(Output* output) : output_(output) {
    output_->publisher = nh_.advertise<sensor_msgs::Image>("image", 1);
  }
  void known_call(unsigned n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    std::fill(image.data.begin(), image.data.end(), 7);
    ROS_INFO("filled");
    output_->publisher.publish(image);
  }
  void local_pointer(int n) {
    Output* output = output_;
    sensor_msgs::Image image;
    image.data.resize(n);
    ros::spinOnce();
    output->publisher.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  Output* output_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher publisher;
// +  tzc::Publisher publisher;
// -    output_->publisher = nh_.advertise<sensor_msgs::Image>("image", 1);
// +    output_->publisher = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -    sensor_msgs::Image image;
// -    image.data.resize(n);
// +    tzc::sensor_msgs::Image image;
// +    output_->publisher.allocate(image);
// +    image.data.resize(n, tzc::uninitialized);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
