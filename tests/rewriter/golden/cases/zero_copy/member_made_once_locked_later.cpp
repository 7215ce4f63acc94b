// The lock is for something else: the publishers are made before anybody looks at them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <mutex>

namespace {

ros::Publisher pub;
std::mutex mutex;
int count = 0;

void publish() {
  sensor_msgs::Image image;
  image.data.resize(100);
  std::lock_guard<std::mutex> lock(mutex);
  ++count;
  pub.publish(image);
}

}  // namespace

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
  void publish() {
    if (pub_.getNumSubscribers() == 0) return;
    sensor_msgs::Image image;
    image.data.resize(100);
    std::lock_guard<std::mutex> lock(mutex_);
    ++count_;
    pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  std::mutex mutex_;
  int count_ = 0;
  ros::Publisher pub_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("other", 1);
  Node node;
  node.publish();
  publish();
}
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image zero_copy 'other'
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:45 sensor_msgs/Image zero_copy 'other'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -ros::Publisher pub;
// +tzc::Publisher pub;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 1); }
// +  Node() { pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1); }
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  pub = nh.advertise<sensor_msgs::Image>("other", 1);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "other", 1);
