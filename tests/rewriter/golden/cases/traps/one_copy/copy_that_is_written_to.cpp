// A copy of a published message shares its elements until the program writes to it, which copies them all.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    kept_ = boost::make_shared<sensor_msgs::Image>(image);
    kept_->data[0] = 2;
    kept_pub_.publish(kept_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher kept_pub_ = nh_.advertise<sensor_msgs::Image>("kept", 1);
  sensor_msgs::ImagePtr kept_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'image' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'kept' TZC1022 it is a copy (made in line 11), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image'
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'kept'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    kept_ = boost::make_shared<sensor_msgs::Image>(image);
// +    kept_ = boost::make_shared<tzc::sensor_msgs::Image>(image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher kept_pub_ = nh_.advertise<sensor_msgs::Image>("kept", 1);
// -  sensor_msgs::ImagePtr kept_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher kept_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "kept", 1);
// +  tzc::sensor_msgs::ImagePtr kept_;
