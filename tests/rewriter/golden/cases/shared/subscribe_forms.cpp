// nh.subscribe with function, member and bind.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void on_image(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%u", image->width); }

class Viewer {
 public:
  explicit Viewer(ros::NodeHandle* nh) {
    a_ = nh->subscribe("image", 1, &Viewer::on_image, this);
    b_ = nh->subscribe<sensor_msgs::Image>("image", 1, boost::bind(&Viewer::on_image_of, this, _1, 3));
  }
  void on_image(const sensor_msgs::ImageConstPtr& image) {}
  void on_image_of(const sensor_msgs::ImageConstPtr& image, int camera) {}

 private:
  ros::Subscriber a_, b_;
};

int main() {
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("image", 1, on_image, ros::TransportHints().tcpNoDelay());
  Viewer viewer(&nh);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:10 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:22 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    a_ = nh->subscribe("image", 1, &Viewer::on_image, this);
// -    b_ = nh->subscribe<sensor_msgs::Image>("image", 1, boost::bind(&Viewer::on_image_of, this, _1, 3));
// +    a_ = tzc::subscribe(*nh, "image", 1, &Viewer::on_image, this);
// +    b_ = tzc::subscribe<sensor_msgs::Image>(*nh, "image", 1, boost::bind(&Viewer::on_image_of, this, _1, 3));
// -  ros::Subscriber sub = nh.subscribe("image", 1, on_image, ros::TransportHints().tcpNoDelay());
// +  ros::Subscriber sub = tzc::subscribe(nh, "image", 1, on_image, ros::TransportHints().tcpNoDelay());
