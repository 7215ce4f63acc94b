// A nodelet: handles from getNodeHandle().
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace nodelet {
class Nodelet {
 public:
  virtual ~Nodelet() {}
  virtual void onInit() = 0;
  ros::NodeHandle& getNodeHandle() const;
  ros::NodeHandle& getPrivateNodeHandle() const;
};
}  // namespace nodelet

class Camera : public nodelet::Nodelet {
  void onInit() override {
    pub_ = getNodeHandle().advertise<sensor_msgs::Image>("image", 1);
    sub_ = getPrivateNodeHandle().subscribe("in", 1, &Camera::on_image, this);
  }
  void on_image(const sensor_msgs::ImageConstPtr& in) {
    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
    image->header = in->header;
    image->data.resize(in->data.size());
    for (unsigned i = 0; i < in->data.size(); ++i) image->data[i] = 255 - in->data[i];
    pub_.publish(image);
  }
  ros::Publisher pub_;
  ros::Subscriber sub_;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image zero_copy 'image'
// subscribe src/node.cpp:18 sensor_msgs/Image shared 'in'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pub_ = getNodeHandle().advertise<sensor_msgs::Image>("image", 1);
// -    sub_ = getPrivateNodeHandle().subscribe("in", 1, &Camera::on_image, this);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(getNodeHandle(), "image", 1);
// +    sub_ = tzc::subscribe(getPrivateNodeHandle(), "in", 1, &Camera::on_image, this);
// -    sensor_msgs::ImagePtr image = boost::make_shared<sensor_msgs::Image>();
// +    tzc::sensor_msgs::ImagePtr image = boost::make_shared<tzc::sensor_msgs::Image>();
// +    pub_.allocate(*image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
