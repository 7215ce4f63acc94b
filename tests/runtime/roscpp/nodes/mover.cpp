// SPDX-License-Identifier: BSD-3-Clause
/// A publisher that runs a race around the move of its subscriber in the order of steps that once went wrong. Prints what
/// happened as lines of JSON ("event").
///
/// Private parameter: race, one of
///   long_move     a publisher with a queue of one: while a subscriber moves over, TCPROS cannot send for a while, and the node
///                 publishes on; it ends when the move does
///   local_writer  a publisher with a subscriber of its own that writes to what it is passed
///   late_greeting a publisher whose connect callback greets the subscriber after it has moved
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>

#include "image_line.h"
#include "race.h"
#include "sync_point/sync_point.h"

namespace tzc_test {
namespace {

/// Publishes at 200 Hz until it has happened, at most 2000 messages: a subscriber keeps up with that. True when it has.
bool publish_until(const tzc::Publisher& publisher, const std::string& event, std::uint32_t from) {
  ros::WallRate rate(200);
  for (std::uint32_t number = from; number < 2000 && !gate().happened(event); ++number) {
    publish(publisher, number, number + 1);
    rate.sleep();
  }
  return gate().happened(event);
}

void long_move(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "move: begins") {
      gate().tell("moving");
      gate().wait_for({"chosen"});
    }
    if (name == "publish: by reference" && gate().happened("moving")) gate().tell("chosen");
    if (name == "move: parked") gate().tell("parked");
    if (name == "move: live") gate().tell("live");
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 1);
  gate().wait_for({"moving"});
  hold_poll_thread_now();
  publish(publisher, 0, 1);
  gate().wait_for({"parked"});
  ros::WallDuration(0.5).sleep();  // by now the worker looks seldom
  publish(publisher, 1, 20);
  gate().tell("let go");
  print_event("live", publish_until(publisher, "live", 20));
}

// The callback gets the published object itself, as with plain roscpp, and another process gets it, too.
void local_writer(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::ImagePtr&)> draw = [](const sensor_msgs::ImagePtr& image) {
    fill_pattern(image->data.data(), image->data.size(), 1000);
    gate().tell("written");
  };
  const ros::Subscriber writer = node.subscribe<sensor_msgs::Image>("image", 1, draw);
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  eventually([&] { return publisher.statistics().shared_subscribers == 1; });
  ros::WallDuration(0.5).sleep();  // the move's end
  ros::AsyncSpinner spinner(1);
  spinner.start();
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "allocate: begin")
      print_event("written before it was copied",
                  gate().wait_for({"written"}, std::chrono::milliseconds(500)));
  };
  const auto image = boost::make_shared<sensor_msgs::Image>();
  fill_image(*image, 0, 20000);
  publisher.publish(image);
  print_event("written", gate().wait_for({"written"}));
  tzc::sync_point_hook = nullptr;
  ros::WallDuration(0.5).sleep();
}

// The callback's queue is spun only when the subscriber has moved, and TCPROS sends nothing for a while.
void late_greeting(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "move: live") gate().tell("live");
  };
  ros::CallbackQueue queue;
  ros::NodeHandle own(node);
  own.setCallbackQueue(&queue);
  const ros::SubscriberStatusCallback greet = [](const ros::SingleSubscriberPublisher& subscriber) {
    sensor_msgs::Image greeting;
    fill_image(greeting, 0, 20000);
    subscriber.publish(greeting);
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(own, "image", 100, greet);
  print_event("live", gate().wait_for({"live"}));
  hold_poll_thread_now();
  queue.callAvailable();
  publish(publisher, 1, 10);
  ros::WallDuration(0.5).sleep();
  let_go_and_end();
}

void run(ros::NodeHandle& node, const std::string& race) {
  if (race == "long_move") long_move(node);
  if (race == "local_writer") local_writer(node);
  if (race == "late_greeting") late_greeting(node);
}

}  // namespace
}  // namespace tzc_test

int main(int argc, char** argv) {
  ros::init(argc, argv, "mover");
  ros::NodeHandle node;
  ros::PollManager::instance()->addPollThreadListener(tzc_test::hold_poll_thread);
  tzc_test::run(node, ros::NodeHandle("~").param<std::string>("race", ""));
  tzc::sync_point_hook = nullptr;
}
