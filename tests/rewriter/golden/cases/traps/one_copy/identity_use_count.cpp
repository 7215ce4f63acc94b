// A new message is made only while subscribers of this process hold the last one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() : image_(boost::make_shared<sensor_msgs::Image>()) {
    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
  }
  void publish() {
    if (image_.use_count() > 1) image_ = boost::make_shared<sensor_msgs::Image>();
    image_->data.push_back(1);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::ImagePtr image_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:13 sensor_msgs/Image one_copy 'image' TZC1001 the program asks who else holds it
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// +    pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
