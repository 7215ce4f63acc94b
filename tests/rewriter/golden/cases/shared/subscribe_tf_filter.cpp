// A tf filter behind a subscriber: the subscriber is ported, the filter takes any.
#include <message_filters/subscriber.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/message_filter.h>

class Mapper {
 public:
  Mapper() {
    subscriber_ = new message_filters::Subscriber<sensor_msgs::PointCloud2>(nh_, "cloud_in", 5);
    filter_ = new tf2_ros::MessageFilter<sensor_msgs::PointCloud2>(*subscriber_, "map", 5);
    filter_->registerCallback(boost::bind(&Mapper::insert, this, _1));
  }
  void insert(const sensor_msgs::PointCloud2::ConstPtr& cloud);

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::PointCloud2>* subscriber_;
  tf2_ros::MessageFilter<sensor_msgs::PointCloud2>* filter_;
};
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/PointCloud2 shared 'cloud_in'
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -    subscriber_ = new message_filters::Subscriber<sensor_msgs::PointCloud2>(nh_, "cloud_in", 5);
// +    subscriber_ = new tzc::message_filters::Subscriber<sensor_msgs::PointCloud2>(nh_, "cloud_in", 5);
// -  message_filters::Subscriber<sensor_msgs::PointCloud2>* subscriber_;
// +  tzc::message_filters::Subscriber<sensor_msgs::PointCloud2>* subscriber_;
