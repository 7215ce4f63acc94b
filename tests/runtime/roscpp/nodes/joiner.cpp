// SPDX-License-Identifier: BSD-3-Clause
/// Shared images that a callback of something else draws on, on a thread that blocks all signals. Prints each image before (image_line.h).
///
/// Private parameters: role (talks: publishes images and, with the stamp of each and after it, a message without arrays, which stays on
/// TCPROS; joins), count; queues (one: the global queue, with four threads; image, other: the images' or the other topic's callbacks have a queue of their own;
/// one thread for each queue), draws (filter: a synchronizer of both topics; callback: that of the other topic; timer), late (the other topic is subscribed to when images
/// have come), plain (subscribes with roscpp alone).
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Temperature.h>
#include <tzc/message_filters.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <boost/bind/bind.hpp>
#include <deque>
#include <mutex>
#include <string>

#include "race.h"

namespace {

using sensor_msgs::Image;
using sensor_msgs::ImageConstPtr;
using sensor_msgs::Temperature;
using sensor_msgs::TemperatureConstPtr;
using tzc_test::eventually;
using tzc_test::gate;

constexpr int queue_size = 100;

void draw(const ImageConstPtr& image) {
  tzc_test::print_image(*image);
  auto& drawn = const_cast<Image&>(*image);
  const int number = std::atoi(image->header.frame_id.c_str());
  tzc_test::fill_pattern(drawn.data.data(), drawn.data.size(), static_cast<std::uint32_t>(number) + 1000);
}

void draw_on_first(const ImageConstPtr& image, const TemperatureConstPtr&) {
  draw(image);
}

/// What one callback keeps and another one draws on.
class Kept {
 public:
  void keep(const ImageConstPtr& image) {
    const std::lock_guard<std::mutex> lock(mutex_);
    images_.push_back(image);
  }
  bool draw_on_next() {
    ImageConstPtr image;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (images_.empty()) return false;
      image = images_.front();
      images_.pop_front();
    }
    draw(image);
    return true;
  }

 private:
  std::mutex mutex_;
  std::deque<ImageConstPtr> images_;
};

struct Nodes {
  ros::NodeHandle image, other;
};

/// In the late case the other topic comes when this node has images that wait for it.
void wait_for_images(const ros::NodeHandle& options) {
  if (options.param("late", false)) gate().wait_for({"image"});
}

void join_by_filter(Nodes& nodes, const ros::NodeHandle& options) {
  tzc::message_filters::Subscriber<Image> images(nodes.image, "image", queue_size);
  const boost::function<void(const ImageConstPtr&)> tell = [](const ImageConstPtr& image) {
    if (tzc::in_segment(image->data.data())) gate().tell("image");
  };
  images.registerCallback(tell);
  message_filters::Subscriber<Temperature> others;
  message_filters::TimeSynchronizer<Image, Temperature> both(images, others, queue_size);
  both.registerCallback(boost::bind(draw_on_first, boost::placeholders::_1, boost::placeholders::_2));
  wait_for_images(options);
  others.subscribe(nodes.other, "temperature", queue_size);
  ros::waitForShutdown();
}

void join_by_hand(Nodes& nodes, const ros::NodeHandle& options) {
  Kept kept;
  const boost::function<void(const ImageConstPtr&)> keep = [&](const ImageConstPtr& image) {
    kept.keep(image);
  };
  const boost::function<void(const TemperatureConstPtr&)> draw_on_kept = [&](const TemperatureConstPtr&) {
    eventually([&] { return kept.draw_on_next(); });
  };
  const ros::Subscriber images = options.param("plain", false)
                                     ? nodes.image.subscribe<Image>("image", queue_size, keep)
                                     : tzc::subscribe<Image>(nodes.image, "image", queue_size, keep);
  const bool has_timer = options.param<std::string>("draws", "") == "timer";
  const boost::function<void(const TemperatureConstPtr&)> ignore = [](const TemperatureConstPtr&) {};
  // A thread that a timer's callback runs on runs no other one.
  ros::NodeHandle& node = has_timer ? nodes.image : nodes.other;
  const ros::Subscriber others =
      node.subscribe<Temperature>("temperature", queue_size, has_timer ? ignore : draw_on_kept);
  const auto draw_on_all = [&](const ros::WallTimerEvent&) {
    while (kept.draw_on_next()) continue;
  };
  const ros::WallTimer timer =
      nodes.other.createWallTimer(ros::WallDuration(0.005), draw_on_all, false, has_timer);
  ros::waitForShutdown();
}

void join(const ros::NodeHandle& options) {
  const std::string queues = options.param<std::string>("queues", "one");
  ros::CallbackQueue own;
  Nodes nodes;
  if (queues == "image") nodes.image.setCallbackQueue(&own);
  if (queues == "other") nodes.other.setCallbackQueue(&own);
  ros::AsyncSpinner global_threads(queues == "one" ? 4 : 1), own_threads(1, &own);
  global_threads.start();
  own_threads.start();
  if (options.param<std::string>("draws", "filter") == "filter")
    join_by_filter(nodes, options);
  else
    join_by_hand(nodes, options);
}

/// Images without an answer go out until the other topic has a subscriber.
void talk(const ros::NodeHandle& options) {
  ros::NodeHandle node;
  const tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", queue_size);
  const ros::Publisher others = node.advertise<Temperature>("temperature", queue_size);
  eventually([&] { return images.statistics().shared_subscribers == 1; });
  ros::WallRate rate(50);
  if (options.param("late", false)) {
    for (std::uint32_t number = 1000; ros::ok() && others.getNumSubscribers() == 0; ++number) {
      tzc_test::publish(images, number, number + 1);
      rate.sleep();
    }
  }
  eventually([&] { return others.getNumSubscribers() == 1; });
  const auto count = static_cast<std::uint32_t>(options.param("count", 20));
  for (std::uint32_t number = 0; number < count; ++number) {
    const tzc::sensor_msgs::Image image = tzc_test::make_image(images, number);
    images.publish(image);
    Temperature other;
    other.header.stamp = image.header.stamp;
    rate.sleep();  // the image is there first
    others.publish(other);
  }
  ros::WallDuration(1).sleep();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "joiner");
  const ros::NodeHandle options("~");
  if (options.param<std::string>("role", "joins") == "talks")
    talk(options);
  else
    join(options);
}
