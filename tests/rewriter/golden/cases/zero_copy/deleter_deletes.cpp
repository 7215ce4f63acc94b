// A shared pointer is given a deleter, which does nothing but delete the message: a closure, a generic one, a function, a class.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void release(sensor_msgs::Image* image) {
  if (image != nullptr) delete image;
}

struct Release {
  void operator()(sensor_msgs::Image* image) const { delete image; }
};

class Node {
 public:
  void by_closure() {
    boost::shared_ptr<sensor_msgs::Image> image(new sensor_msgs::Image, [](sensor_msgs::Image* m) { delete m; });
    image->data.resize(6000);
    pub_.publish(image);
  }
  void by_generic_closure() {
    boost::shared_ptr<sensor_msgs::Image> image(new sensor_msgs::Image, [](auto* m) { delete m; });
    image->data.resize(6000);
    pub_.publish(image);
  }
  void by_function() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image, release);
    image->data.resize(6000);
    pub_.publish(image);
  }
  void by_class() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image(), Release());
    image->data.resize(6000);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
};
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void release(sensor_msgs::Image* image) {
// +void release(tzc::sensor_msgs::Image* image) {
// -  void operator()(sensor_msgs::Image* image) const { delete image; }
// +  void operator()(tzc::sensor_msgs::Image* image) const { delete image; }
// -    boost::shared_ptr<sensor_msgs::Image> image(new sensor_msgs::Image, [](sensor_msgs::Image* m) { delete m; });
// +    boost::shared_ptr<tzc::sensor_msgs::Image> image(new tzc::sensor_msgs::Image, [](tzc::sensor_msgs::Image* m) { delete m; });
// +    pub_.allocate(*image);
// -    boost::shared_ptr<sensor_msgs::Image> image(new sensor_msgs::Image, [](auto* m) { delete m; });
// +    boost::shared_ptr<tzc::sensor_msgs::Image> image(new tzc::sensor_msgs::Image, [](auto* m) { delete m; });
// +    pub_.allocate(*image);
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image, release);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image, release);
// +    pub_.allocate(*image);
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image(), Release());
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image(), Release());
// +    pub_.allocate(*image);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
