// A copy of a message that was not published yet has elements of its own, outside shared memory.
#include <deque>
#include <functional>
#include <optional>

#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Parameter {
 public:
  explicit Parameter(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("parameter", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    send(image);
  }
  void send(sensor_msgs::Image image) { pub_.publish(image); }

 private:
  ros::Publisher pub_;
};

class Queue {
 public:
  explicit Queue(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queue", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    queue_.push_back(image);
    pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_;
  std::deque<sensor_msgs::Image> queue_;
};

sensor_msgs::Image to_message(const cv::Mat& mat) {
  return *cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
}

class Result {
 public:
  explicit Result(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("result", 1)) {}
  void tick(const cv::Mat& mat) { pub_.publish(to_message(mat)); }

 private:
  ros::Publisher pub_;
};

class Optional {
 public:
  explicit Optional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("optional", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    latest_ = image;
    pub_.publish(*latest_);
    latest_.reset();
  }

 private:
  ros::Publisher pub_;
  std::optional<sensor_msgs::Image> latest_;
};

class Temporary {
 public:
  explicit Temporary(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("temporary", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(sensor_msgs::Image(image));
  }

 private:
  ros::Publisher pub_;
};

class Captured {
 public:
  explicit Captured(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("captured", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    tasks_.push_back([this, image] { pub_.publish(image); });
  }

 private:
  ros::Publisher pub_;
  std::deque<std::function<void()>> tasks_;
};

int main() {
  ros::NodeHandle nh;
  Parameter(nh).tick();
  Queue(nh).tick();
  Result(nh).tick(cv::Mat());
  Optional(nh).tick();
  Temporary(nh).tick();
  Captured(nh).tick();
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'parameter'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'parameter' TZC1022 it is a copy (passed to 'send' in line 16), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'queue'
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'queue' TZC1022 it is a copy (stored by 'push_back' in line 30), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'result'
// publish src/node.cpp:47 sensor_msgs/Image one_copy 'result' TZC1022 it is a copy (returned from 'to_message' in line 41), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:55 sensor_msgs/Image one_copy 'optional'
// publish src/node.cpp:60 sensor_msgs/Image one_copy 'optional' TZC1022 it is a copy (assigned to 'latest_' in line 59), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:71 sensor_msgs/Image one_copy 'temporary'
// publish src/node.cpp:75 sensor_msgs/Image one_copy 'temporary' TZC1022 it is a copy (made to be published in line 75), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:84 sensor_msgs/Image one_copy 'captured'
// publish src/node.cpp:88 sensor_msgs/Image one_copy 'captured' TZC1022 it is a copy (made to be published in line 88), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/cv_bridge.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Parameter(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("parameter", 1)) {}
// +  explicit Parameter(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "parameter", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  void send(sensor_msgs::Image image) { pub_.publish(image); }
// +  void send(tzc::sensor_msgs::Image image) { pub_.publish(image); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Queue(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queue", 1)) {}
// +  explicit Queue(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "queue", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
// -sensor_msgs::Image to_message(const cv::Mat& mat) {
// -  return *cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat).toImageMsg();
// +tzc::sensor_msgs::Image to_message(const tzc::Publisher& publisher, const cv::Mat& mat) {
// +  return *tzc::cv_bridge::to_image_msg(cv_bridge::CvImage(std_msgs::Header(), "bgr8", mat), publisher);
// -  explicit Result(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("result", 1)) {}
// -  void tick(const cv::Mat& mat) { pub_.publish(to_message(mat)); }
// +  explicit Result(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "result", 1)) {}
// +  void tick(const cv::Mat& mat) { pub_.publish(to_message(pub_, mat)); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Optional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("optional", 1)) {}
// +  explicit Optional(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "optional", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// -  std::optional<sensor_msgs::Image> latest_;
// +  tzc::Publisher pub_;
// +  std::optional<tzc::sensor_msgs::Image> latest_;
// -  explicit Temporary(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("temporary", 1)) {}
// +  explicit Temporary(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "temporary", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    pub_.publish(sensor_msgs::Image(image));
// +    pub_.publish(tzc::sensor_msgs::Image(image));
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Captured(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("captured", 1)) {}
// +  explicit Captured(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "captured", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
