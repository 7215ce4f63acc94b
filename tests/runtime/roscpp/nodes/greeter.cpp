// SPDX-License-Identifier: BSD-3-Clause
/// A publisher with connect callbacks: prints a line of JSON for each, with the number of subscribers that it
/// saw, and greets each subscriber with an image for it alone (numbers from 1,000,000 up) before it publishes.
///
/// Private parameters: plain (a ros::Publisher), foreign (such a one, published with by tzc::publish), image_transport (one of those), latch, rate (Hz; 0: publish only `before` images), before
/// (images published at the start), bytes.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/image_transport.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>

#include "image_line.h"

namespace {

class Greeter {
 public:
  Greeter(ros::NodeHandle node, ros::NodeHandle options)
      : is_foreign_(options.param("foreign", false)),
        is_image_transports_(options.param("image_transport", false)),
        is_plain_(is_foreign_ || options.param("plain", false)),
        bytes_(options.param("bytes", 100000)) {
    const bool latch = options.param("latch", false);
    if (is_image_transports_) {
      image_transport::ImageTransport transport(node);
      const image_transport::SubscriberStatusCallback greets = on_connect(), tells = on_leave();
      images_ =
          tzc::image_transport::advertise(transport, "image", kQueue, greets, tells, ros::VoidPtr(), latch);
      return;
    }
    const ros::SubscriberStatusCallback greets = on_connect(), tells = on_leave();
    if (is_plain_)
      plain_ = node.advertise<sensor_msgs::Image>("image", kQueue, greets, tells, ros::VoidConstPtr(), latch);
    else
      shared_ = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", kQueue, 0, greets, tells,
                                                        ros::VoidConstPtr(), latch);
  }

  void publish() {
    tzc::sensor_msgs::Image image;
    if (is_image_transports_)
      images_.allocate(image);
    else if (!is_plain_)
      shared_.allocate(image);
    tzc_test::fill_image(image, number_++, bytes_);
    if (is_image_transports_)
      images_.publish(image);
    else if (is_foreign_)
      tzc::publish(plain_, tzc::message::to_stock(image));
    else if (is_plain_)
      plain_.publish(tzc::message::to_stock(image));
    else
      shared_.publish(image);
  }

 private:
  static constexpr std::uint32_t kQueue =
      1000;  // no message is dropped where the machine is busy with others

  /// Callbacks for any kind of publisher.
  struct OnConnect {
    Greeter* greeter;
    template <class Subscriber>
    void operator()(const Subscriber& subscriber) const {
      greeter->greet(subscriber);
    }
  };
  struct OnLeave {
    Greeter* greeter;
    template <class Subscriber>
    void operator()(const Subscriber& subscriber) const {
      greeter->tell("leave", subscriber);
    }
  };
  OnConnect on_connect() { return {this}; }
  OnLeave on_leave() { return {this}; }

  std::uint32_t subscribers() const {
    if (is_image_transports_) return images_.getNumSubscribers();
    return is_plain_ ? plain_.getNumSubscribers() : shared_.getNumSubscribers();
  }
  template <class Subscriber>
  void tell(const char* event, const Subscriber& subscriber) const {
    std::printf("{\"event\": \"%s\", \"subscriber\": \"%s\", \"topic\": \"%s\", \"count\": %u}\n", event,
                subscriber.getSubscriberName().c_str(), subscriber.getTopic().c_str(), subscribers());
    std::fflush(stdout);
  }
  template <class Subscriber>
  void greet(const Subscriber& subscriber) {
    tell("connect", subscriber);
    sensor_msgs::Image greeting;
    tzc_test::fill_image(greeting, 1000000 + greeted_++, bytes_);
    subscriber.publish(greeting);
  }

  const bool is_foreign_, is_image_transports_, is_plain_;
  const std::size_t bytes_;
  std::uint32_t number_ = 0, greeted_ = 0;
  ros::Publisher plain_;
  tzc::Publisher shared_;
  tzc::image_transport::Publisher images_;
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
