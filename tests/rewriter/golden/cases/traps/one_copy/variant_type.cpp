// The program asks a variant for the type that it holds.
#include <boost/variant.hpp>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <typeinfo>

class Node {
 public:
  void tick(int n) {
    sensor_msgs::Image image;
    image.data.assign(n, 7);
    pub_.publish(image);
    last_ = image;
    if (last_.type() == typeid(sensor_msgs::Image)) ROS_INFO("%d images", ++images_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  boost::variant<sensor_msgs::Image, int> last_;
  int images_ = 0;
};
//--- expected
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1001 the program asks for its type
// advertise src/node.cpp:20 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);
