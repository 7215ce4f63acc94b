// The message that is copied stays as it is: nothing publishes it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void keep(const sensor_msgs::Image& image) { prototype_ = image; }
  void tick() {
    sensor_msgs::Image out = prototype_;
    out.data[0]++;
    pub_.publish(out);
  }
  void from_another() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    sensor_msgs::Image out;
    out = image;
    out.data[0]++;
    pub_.publish(out);
  }
  // Both are published, so both are ported.
  void twice() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(image);
    sensor_msgs::Image out = image;
    out.data[0]++;
    pub_.publish(out);
  }
  // The copy of a copy that is published.
  void chain() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(image);
    sensor_msgs::Image between = image;
    sensor_msgs::Image out = between;
    out.data[0]++;
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image prototype_;
};
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:43 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image out = prototype_;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// +    out = prototype_;
// -    sensor_msgs::Image out;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image out = image;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// +    out = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image between = image;
// -    sensor_msgs::Image out = between;
// +    tzc::sensor_msgs::Image between;
// +    pub_.allocate(between);
// +    between = image;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// +    out = between;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
