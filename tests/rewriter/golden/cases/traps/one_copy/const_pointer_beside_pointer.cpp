// Two arguments of one call, one got through const access: the other one may leave it behind.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void spread(unsigned char* out, const unsigned char* in, int n) {
  for (int i = 1; i < n; ++i) out[i] = in[i - 1] + 1;
}

class Node {
 public:
  void step() {
    const sensor_msgs::Image& last = image_;
    spread(image_.data.data(), last.data.data(), 10);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
};
//--- expected
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after its data was written to
// advertise src/node.cpp:19 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
