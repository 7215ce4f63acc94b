// The object is made once, and what stands behind its declaration runs in every call.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  explicit Node(int size) : size_(size) {}
  void tick() {
    static sensor_msgs::ImagePtr next(new sensor_msgs::Image);
    if (!next) {
      next.reset(new sensor_msgs::Image);
    }
    next->data.assign(size_, 7);
    pub_.publish(next);
    next.reset();  // a message that was published is not touched again
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  int size_;
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    static sensor_msgs::ImagePtr next(new sensor_msgs::Image);
// +    static tzc::sensor_msgs::ImagePtr next(new tzc::sensor_msgs::Image);
// -      next.reset(new sensor_msgs::Image);
// +      next.reset(new tzc::sensor_msgs::Image);
// +      pub_.allocate(*next);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
