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
