// The message belongs to an object that is there behind a test only, and has namesakes in other objects.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Frame {
  sensor_msgs::Image image;
};
struct Sweep {
  sensor_msgs::LaserScan scan;
};

class Node {
 public:
  void tick(int k) {
    if (next_) next_->image.data.clear();
    if (frame_) frame_->image.header.stamp = ros::Time::now();
    if (k == 9) frame_ = std::make_unique<Frame>();
    if (frame_) {
      pub_.getNumSubscribers(); frame_->image.data.assign(1000, k);
      pub_.publish(frame_->image);
    }
  }
  void both() {
    Sweep front;
    front.scan.ranges.resize(720);
    Sweep rear;
    rear.scan.ranges.resize(360);
    front_pub_.publish(front.scan);
    rear_pub_.publish(rear.scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher front_pub_ = nh_.advertise<sensor_msgs::LaserScan>("front", 1);
  ros::Publisher rear_pub_ = nh_.advertise<sensor_msgs::LaserScan>("rear", 1);
  std::unique_ptr<Frame> frame_, next_;
};
//--- expected
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:29 sensor_msgs/LaserScan zero_copy 'front'
// publish src/node.cpp:30 sensor_msgs/LaserScan zero_copy 'rear'
// advertise src/node.cpp:35 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:36 sensor_msgs/LaserScan zero_copy 'front'
// advertise src/node.cpp:37 sensor_msgs/LaserScan zero_copy 'rear'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/LaserScan.h>
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  sensor_msgs::LaserScan scan;
// +  tzc::sensor_msgs::LaserScan scan;
// +    front_pub_.allocate(front.scan);
// +    rear_pub_.allocate(rear.scan);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher front_pub_ = nh_.advertise<sensor_msgs::LaserScan>("front", 1);
// -  ros::Publisher rear_pub_ = nh_.advertise<sensor_msgs::LaserScan>("rear", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher front_pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "front", 1);
// +  tzc::Publisher rear_pub_ = tzc::advertise<tzc::sensor_msgs::LaserScan>(nh_, "rear", 1);
