// SPDX-License-Identifier: BSD-3-Clause
/// A publisher with connect callbacks: prints a line of JSON for each, with the number of subscribers that it
/// saw, and greets each subscriber with an image for it alone (numbers from 1,000,000 up) before it publishes.
///
/// Private parameters: plain (a ros::Publisher), foreign (such a one, published with by tzc::publish), latch, rate (Hz; 0: publish only `before` images), before
/// (images published at the start), bytes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>

#include "image_line.h"

namespace {

class Greeter {
 public:
  explicit Greeter(ros::NodeHandle node, ros::NodeHandle options)
      : is_foreign_(options.param("foreign", false)),
        is_plain_(is_foreign_ || options.param("plain", false)),
        bytes_(options.param("bytes", 100000)) {
    const ros::SubscriberStatusCallback on_connect = [this](const ros::SingleSubscriberPublisher& s) {
      greet(s);
    };
    const ros::SubscriberStatusCallback on_leave = [this](const ros::SingleSubscriberPublisher& s) {
      tell("leave", s);
    };
    const bool latch = options.param("latch", false);
    const std::uint32_t queue = 1000;  // no message is dropped where the machine is busy with others
    if (is_plain_)
      plain_ = node.advertise<sensor_msgs::Image>("image", queue, on_connect, on_leave, ros::VoidConstPtr(),
                                                  latch);
    else
      shared_ = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", queue, 0, on_connect, on_leave,
                                                        ros::VoidConstPtr(), latch);
  }

  void publish() {
    tzc::sensor_msgs::Image image;
    if (!is_plain_) shared_.allocate(image);
    tzc_test::fill_image(image, number_++, bytes_);
    if (is_foreign_)
      tzc::publish(plain_, tzc::message::to_stock(image));
    else if (is_plain_)
      plain_.publish(tzc::message::to_stock(image));
    else
      shared_.publish(image);
  }

 private:
  void tell(const char* event, const ros::SingleSubscriberPublisher& subscriber) const {
    const std::uint32_t count = is_plain_ ? plain_.getNumSubscribers() : shared_.getNumSubscribers();
    std::printf("{\"event\": \"%s\", \"subscriber\": \"%s\", \"topic\": \"%s\", \"count\": %u}\n", event,
                subscriber.getSubscriberName().c_str(), subscriber.getTopic().c_str(), count);
    std::fflush(stdout);
  }
  void greet(const ros::SingleSubscriberPublisher& subscriber) {
    tell("connect", subscriber);
    sensor_msgs::Image greeting;
    tzc_test::fill_image(greeting, 1000000 + greeted_++, bytes_);
    subscriber.publish(greeting);
  }

  const bool is_foreign_, is_plain_;
  const std::size_t bytes_;
  std::uint32_t number_ = 0, greeted_ = 0;
  ros::Publisher plain_;
  tzc::Publisher shared_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "greeter");
  ros::NodeHandle node, options("~");
  Greeter greeter(node, options);
  for (int i = options.param("before", 0); i > 0; --i) greeter.publish();
  const double rate = options.param("rate", 0.0);
  ros::Timer timer;
  if (rate > 0)
    timer = node.createTimer(ros::Duration(1 / rate), [&](const ros::TimerEvent&) { greeter.publish(); });
  ros::spin();
}
