// What the constructor hands over runs later.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <mutex>

class Node {
 public:
  Node() {
    later_ = [this] { set_up(); };
  }
  void run() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    pub_.publish(image);
  }

 private:
  void set_up() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }

  ros::NodeHandle nh_;
  std::function<void()> later_;
  std::mutex mutex_;
  ros::Publisher pub_;
};
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1019 it is built where its publisher cannot be named: 'pub_' of line 17 cannot, since another thread may be waited for in between, and may replace it
// advertise src/node.cpp:21 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  void set_up() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  void set_up() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
