// Two buffers change places, so what is written is what was published the time before.
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Arrays {
 public:
  explicit Arrays(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("arrays", 1)) {}
  void tick(int k) {
    back_.data.resize(6000);
    back_.data[k] = 1;
    front_.data.swap(back_.data);
    pub_.publish(front_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image front_, back_;
};

class Messages {
 public:
  explicit Messages(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("messages", 1)) {}
  void tick(int k) {
    back_.data.resize(6000);
    back_.data[k] = 1;
    std::swap(front_, back_);
    pub_.publish(front_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image front_, back_;
};

class Moved {
 public:
  explicit Moved(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("moved", 1)) {}
  void tick(int k) {
    back_.data.resize(6000);
    back_.data[k] = 1;
    sensor_msgs::Image last = std::move(front_);
    front_ = std::move(back_);
    back_ = std::move(last);
    pub_.publish(front_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image front_, back_;
};

int main() {
  ros::NodeHandle nh;
  Arrays arrays(nh);
  Messages messages(nh);
  Moved moved(nh);
  for (int k = 0; k < 9; ++k) {
    arrays.tick(k);
    messages.tick(k);
    moved.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image one_copy 'arrays'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'arrays' TZC1022 line 12 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'messages'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'messages' TZC1022 line 27 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:39 sensor_msgs/Image one_copy 'moved'
// publish src/node.cpp:46 sensor_msgs/Image one_copy 'moved' TZC1022 line 42 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Arrays(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("arrays", 1)) {}
// +  explicit Arrays(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "arrays", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image front_, back_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image front_, back_;
// -  explicit Messages(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("messages", 1)) {}
// +  explicit Messages(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "messages", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image front_, back_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image front_, back_;
// -  explicit Moved(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("moved", 1)) {}
// +  explicit Moved(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "moved", 1)) {}
// -    sensor_msgs::Image last = std::move(front_);
// +    tzc::sensor_msgs::Image last = std::move(front_);
// -  ros::Publisher pub_;
// -  sensor_msgs::Image front_, back_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image front_, back_;
