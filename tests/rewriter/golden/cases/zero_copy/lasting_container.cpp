// Members and globals that hold messages in arrays and containers: the first publish of each binds it to shared memory.
#include <array>
#include <map>
#include <string>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Ring {
 public:
  explicit Ring(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("ring", 1)), frames_(1) {}
  void send(int k) {
    sensor_msgs::Image& frame = frames_.front();
    frame.data.clear();
    for (int i = 0; i < 5000; ++i) frame.data.push_back(k + i);
    pub_.publish(frame);
  }

 private:
  ros::Publisher pub_;
  std::vector<sensor_msgs::Image> frames_;
};

class Array {
 public:
  explicit Array(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("array", 1)) {}
  void send(int k) {
    buffer_[0].data.assign(5000, k);
    pub_.publish(buffer_[0]);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image buffer_[2];
};

class Named {
 public:
  explicit Named(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("named", 1)) {}
  void send(const std::string& name, int k) {
    frames_[name].data.assign(5000, k);
    pub_.publish(frames_[name]);
  }

 private:
  ros::Publisher pub_;
  std::map<std::string, sensor_msgs::Image> frames_;
};

void run(ros::NodeHandle& nh) {
  Ring ring(nh);
  Array array(nh);
  Named named(nh);
  for (int k = 0; ros::ok(); ++k) {
    ring.send(k);
    array.send(k);
    named.send(k % 2 ? "left" : "right", k);
  }
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image zero_copy 'ring'
// publish src/node.cpp:17 sensor_msgs/Image zero_copy 'ring'
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'array'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'array'
// advertise src/node.cpp:40 sensor_msgs/Image zero_copy 'named'
// publish src/node.cpp:43 sensor_msgs/Image zero_copy 'named'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Ring(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("ring", 1)), frames_(1) {}
// +  explicit Ring(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "ring", 1)), frames_(1) {}
// -    sensor_msgs::Image& frame = frames_.front();
// +    tzc::sensor_msgs::Image& frame = frames_.front();
// -  ros::Publisher pub_;
// -  std::vector<sensor_msgs::Image> frames_;
// +  tzc::Publisher pub_;
// +  std::vector<tzc::sensor_msgs::Image> frames_;
// -  explicit Array(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("array", 1)) {}
// +  explicit Array(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "array", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image buffer_[2];
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image buffer_[2];
// -  explicit Named(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("named", 1)) {}
// +  explicit Named(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "named", 1)) {}
// -  ros::Publisher pub_;
// -  std::map<std::string, sensor_msgs::Image> frames_;
// +  tzc::Publisher pub_;
// +  std::map<std::string, tzc::sensor_msgs::Image> frames_;
