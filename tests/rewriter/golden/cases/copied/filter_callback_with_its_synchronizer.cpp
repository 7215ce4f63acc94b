// Another class registers a callback with the synchronizer of this one, and a function that nobody knows is registered with a filter.
#include <functional>

#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

class Filters {
 public:
  using Sync = message_filters::TimeSynchronizer<sensor_msgs::Image, sensor_msgs::Image>;
  explicit Filters(ros::NodeHandle& nh) : left_(nh, "left", 1), right_(nh, "right", 1), sync_(left_, right_, 10) {
    left_.registerCallback(&Filters::look, this);
  }
  void look(const sensor_msgs::ImageConstPtr&) {}
  Sync& sync() { return sync_; }

 private:
  message_filters::Subscriber<sensor_msgs::Image> left_, right_;
  Sync sync_;
};

class Drawing {
 public:
  explicit Drawing(Filters& filters) { filters.sync().registerCallback(&Drawing::draw, this); }
  void draw(const sensor_msgs::ImagePtr&, const sensor_msgs::ImageConstPtr&) {}
};

class Clouds {
 public:
  explicit Clouds(ros::NodeHandle& nh) : clouds_(nh, "clouds", 1) {}
  void on(const std::function<void(const sensor_msgs::PointCloud2ConstPtr&)>& callback) {
    clouds_.registerCallback(callback);
  }

 private:
  message_filters::Subscriber<sensor_msgs::PointCloud2> clouds_;
};
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/Image copied 'left' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:12 sensor_msgs/Image copied 'right' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:31 sensor_msgs/PointCloud2 copied 'clouds' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image> left_, right_;
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> left_, right_;
// -  message_filters::Subscriber<sensor_msgs::PointCloud2> clouds_;
// +  tzc::message_filters::Subscriber<sensor_msgs::PointCloud2> clouds_;
