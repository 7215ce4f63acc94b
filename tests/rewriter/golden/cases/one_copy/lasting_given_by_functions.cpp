// A member that is filled, but never published itself, goes through functions, locals and new objects.
#include <deque>
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Taken {
 public:
  explicit Taken(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("taken", 1)) {}
  void fill(int k) {
    last_ = sensor_msgs::Image();
    last_.data.resize(5000, k);
  }
  sensor_msgs::Image take() { return std::move(last_); }
  void send() {
    sensor_msgs::ImagePtr image;
    image.reset(new sensor_msgs::Image(take()));
    pub_.publish(*image);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image last_;
};

class Wrapped {
 public:
  explicit Wrapped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("wrapped", 1)) {}
  void fill(int k) { last_.data.resize(5000, k); }
  sensor_msgs::Image take() { return std::move(last_); }
  sensor_msgs::Image again() { return take(); }
  sensor_msgs::ImagePtr pointer() { return boost::make_shared<sensor_msgs::Image>(again()); }
  void send() {
    const sensor_msgs::ImagePtr image = pointer();
    pub_.publish(*image);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image last_;
};

class Queued {
 public:
  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
  void fill(int k) { last_.data.resize(5000, k); }
  sensor_msgs::Image take() { return std::move(last_); }
  void keep() {
    sensor_msgs::Image image = take();
    queue_.push_back(std::move(image));
  }
  void send() {
    pub_.publish(queue_.front());
    queue_.pop_front();
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image last_;
  std::deque<sensor_msgs::Image> queue_;
};

void run(ros::NodeHandle& nh) {
  Taken taken(nh);
  Wrapped wrapped(nh);
  Queued queued(nh);
  for (int k = 0; ros::ok(); ++k) {
    taken.fill(k);
    taken.send();
    wrapped.fill(k);
    wrapped.send();
    queued.fill(k);
    queued.keep();
    queued.send();
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'taken'
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'taken' TZC1022 its elements come from a message that is never published itself (returned from 'take' in line 15), and lie outside shared memory
// advertise src/node.cpp:29 sensor_msgs/Image one_copy 'wrapped'
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'wrapped' TZC1022 its elements come from a message that is never published itself (returned from 'take' in line 31), and lie outside shared memory
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'queued'
// publish src/node.cpp:54 sensor_msgs/Image one_copy 'queued' TZC1022 its elements come from a message that is never published itself (returned from 'take' in line 48), and lie outside shared memory
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Taken(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("taken", 1)) {}
// +  explicit Taken(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "taken", 1)) {}
// -    last_ = sensor_msgs::Image();
// +    last_ = tzc::sensor_msgs::Image();
// -  sensor_msgs::Image take() { return std::move(last_); }
// +  tzc::sensor_msgs::Image take() { return std::move(last_); }
// -    sensor_msgs::ImagePtr image;
// -    image.reset(new sensor_msgs::Image(take()));
// +    tzc::sensor_msgs::ImagePtr image;
// +    image.reset(new tzc::sensor_msgs::Image(take()));
// -  ros::Publisher pub_;
// -  sensor_msgs::Image last_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image last_;
// -  explicit Wrapped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("wrapped", 1)) {}
// +  explicit Wrapped(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "wrapped", 1)) {}
// -  sensor_msgs::Image take() { return std::move(last_); }
// -  sensor_msgs::Image again() { return take(); }
// -  sensor_msgs::ImagePtr pointer() { return boost::make_shared<sensor_msgs::Image>(again()); }
// +  tzc::sensor_msgs::Image take() { return std::move(last_); }
// +  tzc::sensor_msgs::Image again() { return take(); }
// +  tzc::sensor_msgs::ImagePtr pointer() { return boost::make_shared<tzc::sensor_msgs::Image>(again()); }
// -    const sensor_msgs::ImagePtr image = pointer();
// +    const tzc::sensor_msgs::ImagePtr image = pointer();
// -  ros::Publisher pub_;
// -  sensor_msgs::Image last_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image last_;
// -  explicit Queued(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("queued", 1)) {}
// +  explicit Queued(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "queued", 1)) {}
// -  sensor_msgs::Image take() { return std::move(last_); }
// +  tzc::sensor_msgs::Image take() { return std::move(last_); }
// -    sensor_msgs::Image image = take();
// +    tzc::sensor_msgs::Image image = take();
// -  ros::Publisher pub_;
// -  sensor_msgs::Image last_;
// -  std::deque<sensor_msgs::Image> queue_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image last_;
// +  std::deque<tzc::sensor_msgs::Image> queue_;
