// The copies share the elements of what was published before.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    copy_pub_.publish(copy(image));
  }

 private:
  static sensor_msgs::Image copy(const sensor_msgs::Image& image) { return image; }
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'copy'
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:18 sensor_msgs/Image zero_copy 'copy'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  static sensor_msgs::Image copy(const sensor_msgs::Image& image) { return image; }
// +  static tzc::sensor_msgs::Image copy(const tzc::sensor_msgs::Image& image) { return image; }
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher copy_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "copy", 1);
