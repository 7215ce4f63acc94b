// A local message, resized and filled: built in shared memory.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.height = 480;
    image.step = 640 * 3;
    image.data.resize(image.step * image.height);
    for (unsigned i = 0; i < image.data.size(); ++i) image.data[i] = i;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Camera() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Camera() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    image.data.resize(image.step * image.height);
// +    image.data.resize(image.step * image.height, tzc::uninitialized);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
