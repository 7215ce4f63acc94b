// The class that subscribes registers a callback that reads; another one, to which the filter is handed, one that may write.
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Camera {
 public:
  Camera() { filter_.registerCallback(&Camera::look, this); }
  void look(const sensor_msgs::ImageConstPtr&) {}
  message_filters::Subscriber<sensor_msgs::Image>& filter() { return filter_; }

 private:
  ros::NodeHandle nh_;
  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "image", 1};
};

class Editor {
 public:
  explicit Editor(Camera& camera) { camera.filter().registerCallback(&Editor::edit, this); }
  void edit(const sensor_msgs::ImagePtr& image) { image->data.clear(); }
};
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image copied 'image' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/message_filters.h>
// -  message_filters::Subscriber<sensor_msgs::Image>& filter() { return filter_; }
// +  tzc::message_filters::Subscriber<sensor_msgs::Image>& filter() { return filter_; }
// -  message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "image", 1};
// +  tzc::message_filters::Subscriber<sensor_msgs::Image> filter_{nh_, "image", 1};
