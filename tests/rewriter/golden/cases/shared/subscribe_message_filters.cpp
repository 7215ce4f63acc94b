// message_filters with a synchronizer.
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class Node {
 public:
  Node() : image_(nh_, "image", 1), sync_(image_, cloud_, 10) {
    cloud_.subscribe(nh_, "points", 1);
    sync_.registerCallback(boost::bind(&Node::callback, this, _1, _2));
  }
  void callback(const sensor_msgs::ImageConstPtr& image, const sensor_msgs::PointCloud2ConstPtr& cloud) {}

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> image_;
  message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_;
  message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::PointCloud2> sync_;
};
//--- expected
// subscribe src/node.cpp:8 sensor_msgs/Image shared 'image'
// subscribe src/node.cpp:9 sensor_msgs/PointCloud2 shared 'points'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> image_;
// -  message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> image_;
// +  tzc::message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_;
