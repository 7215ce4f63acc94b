// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/poll_manager.h>
#include <ros/ros.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <cstdio>
#include <string>

#include "gate.h"
#include "image_line.h"

namespace tzc_test {

inline Gate& gate() {
  static auto* const instance = new Gate;
  return *instance;
}

inline void print_event(const std::string& event, bool happened) {
  std::printf("{\"event\": \"%s\", \"happened\": %s}\n", event.c_str(), happened ? "true" : "false");
  std::fflush(stdout);
}

/// Keeps roscpp's poll thread from everything between "hold" and "let go".
inline void hold_poll_thread() {
  if (!gate().happened("hold") || gate().happened("let go")) return;
  gate().tell("held");
  gate().wait_for({"let go"});
}

inline tzc::sensor_msgs::Image make_image(const tzc::Publisher& publisher, std::uint32_t number) {
  tzc::sensor_msgs::Image image;
  publisher.allocate(image);
  fill_image(image, number, 20000);
  return image;
}

inline void publish(const tzc::Publisher& publisher, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t number = from; number < to; ++number) publisher.publish(make_image(publisher, number));
}

/// Releases the poll thread, if it is held, so that it sends what was published; then the node may end.
inline void let_go_and_end() {
  gate().tell("let go");
  ros::WallDuration(1.0).sleep();
}

template <class Condition>
bool eventually(Condition holds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(120);
  while (ros::ok() && !holds() && ros::WallTime::now() < end) ros::WallDuration(0.001).sleep();
  return holds();
}

inline void hold_poll_thread_now() {
  gate().tell("hold");
  ros::PollManager::instance()->getPollSet().signal();
  gate().wait_for({"held"});
}

}  // namespace tzc_test
