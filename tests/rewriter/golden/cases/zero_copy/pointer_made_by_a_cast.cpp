// A new object whose smart pointer is written out: the pointer that it ends in names it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Driver {
 public:
  void assigned() {
    image_ = sensor_msgs::ImagePtr(new sensor_msgs::Image);
    image_->data.resize(100);
    pub_.publish(image_);
  }
  void initialised() {
    sensor_msgs::ImagePtr image = boost::shared_ptr<sensor_msgs::Image>(new sensor_msgs::Image());
    image->data.resize(100);
    pub_.publish(image);
  }
  void cast() {
    sensor_msgs::Image* image;
    image = static_cast<sensor_msgs::Image*>(new sensor_msgs::Image);
    image->data.resize(100);
    pub_.publish(*image);
    delete image;
  }
  void in_braces() {
    sensor_msgs::ImagePtr image;
    image = sensor_msgs::ImagePtr{new sensor_msgs::Image};
    image->data.resize(100);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::ImagePtr image_;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    image_ = sensor_msgs::ImagePtr(new sensor_msgs::Image);
// +    image_ = tzc::sensor_msgs::ImagePtr(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image_);
// -    sensor_msgs::ImagePtr image = boost::shared_ptr<sensor_msgs::Image>(new sensor_msgs::Image());
// +    tzc::sensor_msgs::ImagePtr image = boost::shared_ptr<tzc::sensor_msgs::Image>(new tzc::sensor_msgs::Image());
// +    pub_.allocate(*image);
// -    sensor_msgs::Image* image;
// -    image = static_cast<sensor_msgs::Image*>(new sensor_msgs::Image);
// +    tzc::sensor_msgs::Image* image;
// +    image = static_cast<tzc::sensor_msgs::Image*>(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*image);
// -    sensor_msgs::ImagePtr image;
// -    image = sensor_msgs::ImagePtr{new sensor_msgs::Image};
// +    tzc::sensor_msgs::ImagePtr image;
// +    image = tzc::sensor_msgs::ImagePtr{new tzc::sensor_msgs::Image};
// +    pub_.allocate(*image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::ImagePtr image_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::ImagePtr image_;
