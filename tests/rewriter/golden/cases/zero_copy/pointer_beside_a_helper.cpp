// What a function builds is sent by its own publisher, if there is one, and by that of a helper: allocated by neither if it is null.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Debugged {
 public:
  explicit Debugged(bool debug) {
    image_ = nh_.advertise<sensor_msgs::Image>("image", 10);
    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 10)));
  }
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (debug_) debug_->publish(image);
    send(image_, image);
  }

 private:
  static void send(const ros::Publisher& publisher, const sensor_msgs::Image& image) { publisher.publish(image); }

  ros::NodeHandle nh_;
  ros::Publisher image_;
  boost::shared_ptr<ros::Publisher> debug_;
};

class Chosen {
 public:
  Chosen() : left_(nh_.advertise<sensor_msgs::Image>("left", 10)), right_(nh_.advertise<sensor_msgs::Image>("right", 10)) {}
  void publish(int n) {
    sensor_msgs::Image image;
    image.data.resize(n);
    if (chosen_) chosen_->publish(image);
    hand_on(image);
  }
  void choose(bool left) { chosen_.reset(new ros::Publisher(left ? left_ : right_)); }

 private:
  void hand_on(const sensor_msgs::Image& image) {
    static ros::Publisher all = nh_.advertise<sensor_msgs::Image>("all", 10);
    all.publish(image);
  }

  ros::NodeHandle nh_;
  ros::Publisher left_, right_;
  boost::shared_ptr<ros::Publisher> chosen_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:14 sensor_msgs/Image zero_copy 'debug'
// publish src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'left'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy 'right'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy
// advertise src/node.cpp:39 sensor_msgs/Image zero_copy 'all'
// publish src/node.cpp:40 sensor_msgs/Image zero_copy 'all'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    image_ = nh_.advertise<sensor_msgs::Image>("image", 10);
// -    if (debug) debug_.reset(new ros::Publisher(nh_.advertise<sensor_msgs::Image>("debug", 10)));
// +    image_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 10);
// +    if (debug) debug_.reset(new tzc::Publisher(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "debug", 10)));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    image_.allocate(image);
// -  static void send(const ros::Publisher& publisher, const sensor_msgs::Image& image) { publisher.publish(image); }
// +  static void send(const tzc::Publisher& publisher, const tzc::sensor_msgs::Image& image) { publisher.publish(image); }
// -  ros::Publisher image_;
// -  boost::shared_ptr<ros::Publisher> debug_;
// +  tzc::Publisher image_;
// +  boost::shared_ptr<tzc::Publisher> debug_;
// -  Chosen() : left_(nh_.advertise<sensor_msgs::Image>("left", 10)), right_(nh_.advertise<sensor_msgs::Image>("right", 10)) {}
// +  Chosen() : left_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "left", 10)), right_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "right", 10)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    if (chosen_) chosen_->allocate(image); else tzc::allocate(image);
// -  void choose(bool left) { chosen_.reset(new ros::Publisher(left ? left_ : right_)); }
// +  void choose(bool left) { chosen_.reset(new tzc::Publisher(left ? left_ : right_)); }
// -  void hand_on(const sensor_msgs::Image& image) {
// -    static ros::Publisher all = nh_.advertise<sensor_msgs::Image>("all", 10);
// +  void hand_on(const tzc::sensor_msgs::Image& image) {
// +    static tzc::Publisher all = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "all", 10);
// -  ros::Publisher left_, right_;
// -  boost::shared_ptr<ros::Publisher> chosen_;
// +  tzc::Publisher left_, right_;
// +  boost::shared_ptr<tzc::Publisher> chosen_;
