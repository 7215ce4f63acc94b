// The helper overrides a function of another package.
#include <other/library.h>

class Camera : public other::Source {
 public:
  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void fill(sensor_msgs::Image& image) override { image.data.resize(10); }
  void publish() {
    sensor_msgs::Image image;
    fill(image);
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1005 'fill' overrides a function of another package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Camera() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
