// A constant copy cannot be assigned later, and need not be: it shares the elements of the message that was just published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    if (count % 100 == 0) {
      const sensor_msgs::Image again = image;
      again_pub_.publish(again);
    }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher again_pub_ = nh_.advertise<sensor_msgs::Image>("again", 1);
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image zero_copy 'again'
// advertise src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'again'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -      const sensor_msgs::Image again = image;
// +      const tzc::sensor_msgs::Image again = image;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher again_pub_ = nh_.advertise<sensor_msgs::Image>("again", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher again_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "again", 1);
