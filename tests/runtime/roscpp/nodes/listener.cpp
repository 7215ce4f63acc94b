// SPDX-License-Identifier: BSD-3-Clause
/// Prints a line for each image it gets (image_line.h).
///
/// Private parameters: mode (pointer, reference, value, mutable, event, direct, direct_throw: its callback throws, direct_no_memory: likewise std::bad_alloc, filter,
/// stock_filter: message_filters' own, behind which messages are given other memory, late_attach, unreliable, plain, keep:
/// pointers, all of which it keeps, draw and plain_draw: they write to what they get through a cast and publish it again as
/// `drawn`; with several topics pointer, keep or direct), handler (the number of the message after which a handler of SIGSEGV
/// is installed), times (so many callbacks), again (seconds after which there is one more callback), answers (a topic, on which it says the number of each image that a pointer or
/// keep callback has had), topics (several, separated by blanks), queue, spinner (spin, tzc, multi, async, own: a callback
/// queue of its own, afterwards: no callback is called before the publisher has come and gone).
#include <message_filters/subscriber.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/message_filters.h>
#include <tzc/ros.h>

#include <csignal>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

extern "C" void exit_with_9(int) {
  std::_Exit(9);
}

using tzc_test::print_image;

/// What a talker that waits for its listeners hears from this one: the numbers of images that it has had.
class Answers {
 public:
  void begin(ros::NodeHandle& node, const std::string& topic) {
    if (!topic.empty()) publisher_ = node.advertise<sensor_msgs::Image>(topic, 100);
  }

  /// A publisher that outlives main would keep roscpp from shutting down.
  void end() {
    if (publisher_) publisher_ = ros::Publisher();
  }

  void answer(const sensor_msgs::Image& received) const {
    if (!publisher_) return;
    sensor_msgs::Image answer;
    answer.header.frame_id = received.header.frame_id;
    publisher_.publish(answer);
  }

 private:
  ros::Publisher publisher_;
};

Answers& answers() {
  static auto* const answers = new Answers;
  return *answers;
}

void spoil(sensor_msgs::Image& image) {
  if (!image.data.empty()) image.data[0] ^= 0xff;
}

void on_pointer(const sensor_msgs::ImageConstPtr& image) {
  print_image(*image);
  answers().answer(*image);
}
void keep(const sensor_msgs::ImageConstPtr& image) {
  static auto* const kept = new std::vector<sensor_msgs::ImageConstPtr>;
  kept->push_back(image);
}
void on_kept(const sensor_msgs::ImageConstPtr& image) {
  keep(image);
  print_image(*image);
  answers().answer(*image);
}
void on_reference(const sensor_msgs::Image& image) {
  print_image(image);
}
void on_value(sensor_msgs::Image image) {
  print_image(image);
  spoil(image);
}
void on_mutable(const sensor_msgs::ImagePtr& image) {
  print_image(*image);
  spoil(*image);
}
/// What may not happen to a message in shared memory: it is given other memory.
void on_growing(const sensor_msgs::ImagePtr& image) {
  print_image(*image);
  image->data.resize(2 * image->data.size() + 1);
  *image = sensor_msgs::Image();
}
void on_throwing(const sensor_msgs::ImageConstPtr&) {
  throw std::runtime_error("as callbacks do");
}
void on_message_too_large(const sensor_msgs::ImageConstPtr&) {
  throw std::bad_alloc();
}
void on_event(const ros::MessageEvent<sensor_msgs::Image>& event) {
  print_image(*event.getMessage());
  spoil(*event.getMessage());
}

/// A subscriber that draws on what it gets, as one that writes to toCvShare(...)->image.
class Draws {
 public:
  Draws(ros::NodeHandle& node, int handler_after)
      : handler_after_(handler_after), drawn_(node.advertise<sensor_msgs::Image>("drawn", 100)) {}

  void operator()(const sensor_msgs::ImageConstPtr& received) const {
    print_image(*received);
    auto& image = const_cast<sensor_msgs::Image&>(*received);
    const int number = std::atoi(image.header.frame_id.c_str());
    tzc_test::fill_pattern(image.data.data(), image.data.size(), static_cast<std::uint32_t>(number) + 1000);
    image.header.frame_id = std::to_string(number + 1000);
    drawn_.publish(received);
    if (number == handler_after_) install_handler();
  }

 private:
  /// Once more messages have been taken, which wait for their callbacks.
  static void install_handler() {
    ros::WallDuration(0.2).sleep();
    std::signal(SIGSEGV, exit_with_9);
  }

  const int handler_after_;
  const ros::Publisher drawn_;
};

ros::Subscriber draw(ros::NodeHandle& node, const std::string& mode, const std::string& topic, int queue) {
  const int handler_after = ros::NodeHandle("~").param("handler", -1);
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> draws = Draws(node, handler_after);
  if (mode == "direct_draw") return tzc::subscribe_direct<sensor_msgs::Image>(node, topic, queue, draws);
  return mode == "draw" ? tzc::subscribe<sensor_msgs::Image>(node, topic, queue, draws)
                        : node.subscribe<sensor_msgs::Image>(topic, queue, draws);
}

ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& mode, const std::string& topic,
                          int queue) {
  if (mode == "pointer") return tzc::subscribe(node, topic, queue, on_pointer);
  if (mode == "keep") return tzc::subscribe(node, topic, queue, on_kept);
  if (mode == "reference") return tzc::subscribe(node, topic, queue, on_reference);
  if (mode == "value") return tzc::subscribe(node, topic, queue, on_value);
  if (mode == "mutable") return tzc::subscribe(node, topic, queue, on_mutable);
  if (mode == "event") return tzc::subscribe(node, topic, queue, on_event);
  if (mode == "direct") return tzc::subscribe_direct(node, topic, queue, on_pointer);
  if (mode == "direct_throw") return tzc::subscribe_direct(node, topic, queue, on_throwing);
  if (mode == "direct_no_memory") return tzc::subscribe_direct(node, topic, queue, on_message_too_large);
  if (mode == "unreliable")
    return tzc::subscribe(node, topic, queue, on_pointer, ros::TransportHints().unreliable());
  if (mode == "draw" || mode == "plain_draw" || mode == "direct_draw") return draw(node, mode, topic, queue);
  const ros::Subscriber subscriber = node.subscribe(topic, queue, on_pointer);
  if (mode == "late_attach") tzc::attach<sensor_msgs::Image>(node, topic);
  return subscriber;
}

std::vector<ros::Subscriber> subscribe_named(ros::NodeHandle& node, const std::string& mode,
                                             std::istringstream topics, int queue) {
  std::vector<ros::Subscriber> subscribers;
  for (std::string topic; topics >> topic;) {
    const boost::function<void(const sensor_msgs::ImageConstPtr&)> callback =
        [topic, keeps = mode == "keep"](const sensor_msgs::ImageConstPtr& image) {
          if (keeps) keep(image);
          print_image(*image, "\"topic\": \"" + topic + "\", ");
        };
    subscribers.push_back(mode == "direct"
                              ? tzc::subscribe_direct<sensor_msgs::Image>(node, topic, queue, callback)
                              : tzc::subscribe<sensor_msgs::Image>(node, topic, queue, callback));
  }
  return subscribers;
}

void wait_for_the_end_of(const ros::Subscriber& subscriber) {
  for (const bool is_there : {true, false})
    while (ros::ok() && (subscriber.getNumPublishers() > 0) != is_there) ros::WallDuration(0.01).sleep();
}

void spin(const std::string& spinner, ros::CallbackQueue& own) {
  if (spinner == "tzc") {
    tzc::spin();
  } else if (spinner == "tzc_multi") {
    tzc::MultiThreadedSpinner(3).spin();
  } else if (spinner == "tzc_async" || spinner == "tzc_own") {
    tzc::AsyncSpinner threads(2, spinner == "tzc_own" ? &own : nullptr);
    threads.start();
    ros::waitForShutdown();
  } else if (spinner == "own") {
    while (ros::ok()) own.callAvailable(ros::WallDuration(0.05));
  } else if (spinner == "own_async") {
    ros::AsyncSpinner threads(2, &own);
    threads.start();
    ros::waitForShutdown();
  } else if (spinner == "multi") {
    ros::MultiThreadedSpinner(3).spin();
  } else if (spinner == "async") {
    ros::AsyncSpinner threads(2);
    threads.start();
    ros::waitForShutdown();
  } else {
    ros::spin();
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "listener", ros::init_options::AnonymousName);
  ros::NodeHandle node, options("~");
  const std::string mode = options.param<std::string>("mode", "pointer");
  const std::string spinner = options.param<std::string>("spinner", "spin");
  const std::string topics = options.param<std::string>("topics", "");
  const int queue = options.param("queue", 100);
  answers().begin(node, options.param<std::string>("answers", ""));
  ros::CallbackQueue own;
  if (spinner.find("own") != std::string::npos) node.setCallbackQueue(&own);
  std::unique_ptr<tzc::message_filters::Subscriber<sensor_msgs::Image>> filter;
  message_filters::Subscriber<sensor_msgs::Image> stock_filter;
  std::vector<ros::Subscriber> subscribers;
  if (!topics.empty()) {
    subscribers = subscribe_named(node, mode, std::istringstream(topics), queue);
  } else if (mode == "filter") {
    filter.reset(new tzc::message_filters::Subscriber<sensor_msgs::Image>(node, "image", queue));
    filter->registerCallback(on_mutable);
  } else if (mode == "stock_filter") {
    stock_filter.subscribe(node, "image", queue);
    stock_filter.registerCallback(on_growing);
  } else {
    for (int times = options.param("times", 1); times > 0; --times)
      subscribers.push_back(subscribe(node, mode, "image", queue));
  }
  const double again = options.param("again", 0.0);
  const auto subscribe_again = [&](const ros::WallTimerEvent&) {
    subscribers.push_back(subscribe(node, mode, "image", queue));
  };
  const ros::WallTimer later =
      node.createWallTimer(ros::WallDuration(again), subscribe_again, true, again > 0);
  if (spinner == "afterwards") wait_for_the_end_of(subscribers.front());
  spin(spinner, own);
  answers().end();
}
