// A message in a struct that the function makes is allocated where the struct is declared; in a struct that lasts it is not.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int count = 0;
};

void fill(Frame& frame, int n) { frame.image.data.assign(n, 1); }
void fill_pointed(Frame* frame, int n) { frame->image.data.assign(n, 2); }

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void local() {
    Frame frame;
    if (frame.count != 0) return;
    fill(frame, 10);
    pub_.publish(frame.image);
  }
  void shared() {
    auto frame = boost::make_shared<Frame>();
    fill_pointed(frame.get(), 10);
    pub_.publish(frame->image);
  }
  void kept() {
    kept_.count = 2;
    fill(kept_, 10);
    pub_.publish(kept_.image);
  }
  void element() {
    Frame& frame = frames_[1];
    fill(frame, 10);
    pub_.publish(frame.image);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  Frame kept_;
  Frame frames_[2];
};
//--- expected
// advertise src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// +    pub_.allocate(frame.image);
// +    pub_.allocate(frame->image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
