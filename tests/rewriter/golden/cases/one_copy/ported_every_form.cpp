// What an earlier run ported is in the report, with its level, and stays as it is.
#include <image_transport/image_transport.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/image_transport.h>
#include <tzc/message_filters.h>
#include <tzc/pcl.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

class Node {
 public:
  Node() : filter_(nh_, "left", 1) {
    pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1, 0);
    big_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "big", 1, 1 << 20, true);
    ros::AdvertiseOptions options;
    other_ = tzc::advertise<sensor_msgs::PointCloud2>(nh_, options, 0);
    image_transport::ImageTransport it(nh_);
    it_pub_ = tzc::image_transport::advertise(it, "raw", 1);
    sub_ = tzc::subscribe(nh_, "in", 1, &Node::on_image, this);
    writer_ = tzc::subscribe(nh_, "in", 1, &Node::on_writable, this);
    lambda_ = tzc::subscribe<sensor_msgs::Image>(nh_, "in", 1, [](const sensor_msgs::ImageConstPtr&) {});
    it_sub_ = tzc::image_transport::subscribe(it, "raw", 1, &Node::on_image, this);
  }

 private:
  void on_image(const sensor_msgs::ImageConstPtr& in) {
    pub_.publish(in);
    tzc::sensor_msgs::Image out;
    pub_.allocate(out);
    out.data.resize(10);
    pub_.publish(out);
    big_.publish(boost::make_shared<tzc::sensor_msgs::Image>());
    it_pub_.publish(out);
  }
  void on_writable(const sensor_msgs::ImagePtr&) {}

  ros::NodeHandle nh_;
  tzc::Publisher pub_, big_, other_;
  tzc::image_transport::Publisher it_pub_;
  ros::Subscriber sub_, writer_, lambda_;
  image_transport::Subscriber it_sub_;
  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_;
};
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image shared 'left'
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:16 sensor_msgs/Image zero_copy 'big'
// advertise src/node.cpp:18 sensor_msgs/PointCloud2 one_copy
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'raw'
// subscribe src/node.cpp:21 sensor_msgs/Image copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:22 sensor_msgs/Image copied 'in' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:23 sensor_msgs/Image copied 'in' TZC2001 another callback of the topic takes the message as its own, so all of them get copies
// subscribe src/node.cpp:24 sensor_msgs/Image shared 'raw'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'image' TZC1004 it comes in through the callback 'on_image'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'big'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'raw'
