// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>

#include <chrono>

namespace tzc {
namespace detail {

/// Whether the subscription has got every message that reached a TCPROS connection whose publisher has stopped sending
/// on it. One thread.
class TcprosDrain {
 public:
  /// True also when the connection was dropped, or when its socket is not empty 5 s after the first call, or after one that
  /// came more than a second after the call before it. Does not wait.
  bool is_over(ros::Connection& connection);
  /// Blocks until it is.
  void wait(ros::Connection& connection);

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point deadline_{}, last_look_{};
};

}  // namespace detail
}  // namespace tzc
