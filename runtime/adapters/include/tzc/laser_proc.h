// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MultiEchoLaserScan.h>
#include <tzc/attach.h>

#include <string>
#include <type_traits>

namespace tzc {
namespace laser_proc {

/// For laser_proc::LaserPublisher, which advertises its topics (echoes, first, last, most_intense) and publishes on them by itself: attaches
/// shared memory to each, for as long as the program advertises it, and returns the publisher. The scans are copied once into shared
/// memory. `publisher`: converts to false when it is empty, and tells its resolved topics by getTopics(). Thread-safe.
template <class LaserPublisher>
LaserPublisher attached(const LaserPublisher& publisher) {
  if (!publisher) return publisher;
  for (const std::string& topic : publisher.getTopics()) {
    // A topic of the other type is left alone.
    ::tzc::detail::lasting_attachment<::sensor_msgs::LaserScan>(topic, std::true_type());
    ::tzc::detail::lasting_attachment<::sensor_msgs::MultiEchoLaserScan>(topic, std::true_type());
  }
  return publisher;
}

}  // namespace laser_proc
}  // namespace tzc
