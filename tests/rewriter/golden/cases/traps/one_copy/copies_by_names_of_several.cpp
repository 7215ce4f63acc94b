// A copy of what was not published lies outside shared memory, whichever name fills the original, holds the copy or chooses it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Choice {
 public:
  explicit Choice(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("choice", 1)) {}
  void tick(bool left) {
    sensor_msgs::Image& filled = left ? left_ : right_;
    filled.data.resize(6000);
    send(left_);
    send(right_);
  }

 private:
  void send(sensor_msgs::Image image) { pub_.publish(image); }

  ros::Publisher pub_;
  sensor_msgs::Image left_, right_;
};

class Pointers {
 public:
  explicit Pointers(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("pointers", 1)) {}
  void tick() {
    sensor_msgs::Image* const both[] = {&left_, &right_};
    for (sensor_msgs::Image* image : both) image->data.resize(6000);
    const sensor_msgs::Image copy = left_;
    pub_.publish(copy);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image left_, right_;
};

void captured(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("captured", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  const auto send = [&pub, copy = image] { pub.publish(copy); };
  send();
}

sensor_msgs::Image rotated(const sensor_msgs::Image& image) {
  sensor_msgs::Image out = image;
  out.data[0] = 1;
  return out;
}

void chosen(ros::NodeHandle& nh, bool rotates) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("chosen", 1);
  sensor_msgs::Image image;
  image.data.resize(6000);
  pub.publish(rotates ? rotated(image) : image);
}

int main() {
  ros::NodeHandle nh;
  Choice(nh).tick(true);
  Pointers(nh).tick();
  captured(nh);
  chosen(nh, true);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'choice'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'choice' TZC1022 its elements come from a message that is never published itself (passed to 'send' in line 11), and lie outside shared memory
// advertise src/node.cpp:24 sensor_msgs/Image one_copy 'pointers'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'pointers' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:38 sensor_msgs/Image one_copy 'captured'
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'captured' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:52 sensor_msgs/Image one_copy 'chosen'
// publish src/node.cpp:55 sensor_msgs/Image one_copy 'chosen' TZC1022 it is a copy (made in line 55), whose elements lie outside shared memory until it is published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Choice(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("choice", 1)) {}
// +  explicit Choice(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "choice", 1)) {}
// -    sensor_msgs::Image& filled = left ? left_ : right_;
// +    tzc::sensor_msgs::Image& filled = left ? left_ : right_;
// -  void send(sensor_msgs::Image image) { pub_.publish(image); }
// +  void send(tzc::sensor_msgs::Image image) { pub_.publish(image); }
// -  ros::Publisher pub_;
// -  sensor_msgs::Image left_, right_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image left_, right_;
// -  explicit Pointers(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("pointers", 1)) {}
// +  explicit Pointers(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "pointers", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("captured", 1);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "captured", 1);
// -sensor_msgs::Image rotated(const sensor_msgs::Image& image) {
// -  sensor_msgs::Image out = image;
// +tzc::sensor_msgs::Image rotated(const tzc::Publisher& publisher, const tzc::sensor_msgs::Image& image) {
// +  tzc::sensor_msgs::Image out;
// +  publisher.allocate(out);
// +  out = image;
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("chosen", 1);
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "chosen", 1);
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  pub.publish(rotates ? rotated(image) : image);
// +  pub.publish(rotates ? rotated(pub, image) : image);
