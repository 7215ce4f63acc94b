// What a subscription calls is set later, taken from a map, or returned by a function: it may draw into the image.
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>

typedef boost::function<void(const sensor_msgs::ImageConstPtr&)> Callback;

void look(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%u", image->width); }
void draw(const sensor_msgs::ImageConstPtr& image) {
  cv::Mat mat = cv_bridge::toCvShare(image)->image;
  mat.setTo(0);
}
Callback callback_of(bool draws) { return draws ? Callback(draw) : Callback(look); }

class Node {
 public:
  Node(bool draws, const std::string& name) {
    Callback callback;
    if (draws)
      callback = draw;
    else
      callback = look;
    set_later_ = nh_.subscribe<sensor_msgs::Image>("one", 1, callback);
    callbacks_["look"] = look;
    callbacks_["draw"] = draw;
    of_map_ = nh_.subscribe<sensor_msgs::Image>("two", 1, callbacks_[name]);
    returned_ = nh_.subscribe<sensor_msgs::Image>("three", 1, callback_of(draws));
  }

 private:
  ros::NodeHandle nh_;
  std::map<std::string, Callback> callbacks_;
  ros::Subscriber set_later_, of_map_, returned_;
};
//--- expected
// subscribe src/node.cpp:25 sensor_msgs/Image copied 'one' TZC2001 the callback is not known here, and pages that it writes to are copied
// subscribe src/node.cpp:28 sensor_msgs/Image copied 'two' TZC2001 the callback is not known here, and pages that it writes to are copied
// subscribe src/node.cpp:29 sensor_msgs/Image copied 'three' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    set_later_ = nh_.subscribe<sensor_msgs::Image>("one", 1, callback);
// +    set_later_ = tzc::subscribe<sensor_msgs::Image>(nh_, "one", 1, callback);
// -    of_map_ = nh_.subscribe<sensor_msgs::Image>("two", 1, callbacks_[name]);
// -    returned_ = nh_.subscribe<sensor_msgs::Image>("three", 1, callback_of(draws));
// +    of_map_ = tzc::subscribe<sensor_msgs::Image>(nh_, "two", 1, callbacks_[name]);
// +    returned_ = tzc::subscribe<sensor_msgs::Image>(nh_, "three", 1, callback_of(draws));
