// Filters are given to synchronizers that make_shared and make_unique make.
#include <memory>
#include <message_filters/subscriber.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class Stereo {
 public:
  using Sync = message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::Image>;
  explicit Stereo(ros::NodeHandle& nh) {
    left_.subscribe(nh, "left", 1);
    right_.subscribe(nh, "right", 1);
    shared_ = boost::make_shared<Sync>(left_, right_, 10);
    unique_ = std::make_unique<Sync>(left_, right_, 10);
    shared_->registerCallback(&Stereo::seen, this);
  }
  void seen(const sensor_msgs::ImageConstPtr&, const sensor_msgs::ImageConstPtr&) {}

 private:
  message_filters::Subscriber<sensor_msgs::Image> left_, right_;
  boost::shared_ptr<Sync> shared_;
  std::unique_ptr<Sync> unique_;
};
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image shared 'left'
// subscribe src/node.cpp:12 sensor_msgs/Image shared 'right'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> left_, right_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> left_, right_;
