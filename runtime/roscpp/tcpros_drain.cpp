// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/tcpros_drain.h"

#include <ros/poll_manager.h>
#include <sys/ioctl.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "roscpp/roscpp_access.h"

namespace tzc {
namespace {

using Clock = std::chrono::steady_clock;

/// Rounds that roscpp's poll thread has begun. What a round reads it also hands over before the next one begins.
std::atomic<std::uint64_t>& poll_rounds() {
  static std::atomic<std::uint64_t> rounds{0};
  static const boost::signals2::connection listener =
      ros::PollManager::instance()->addPollThreadListener([] { ++rounds; });
  (void)listener;
  return rounds;
}

bool socket_is_empty(ros::Connection& connection) {
  const auto tcp = boost::dynamic_pointer_cast<ros::TransportTCP>(connection.getTransport());
  int unread = 0;
  return !tcp || ioctl(roscpp_access::sock_(*tcp), FIONREAD, &unread) != 0 || unread == 0;
}

template <class Condition>
bool wait_for(ros::Connection& connection, Clock::time_point deadline, Condition condition) {
  while (!condition()) {
    if (connection.isDropped() || Clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace

void wait_until_drained(ros::Connection& connection) {
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(5);
  std::atomic<std::uint64_t>& rounds = poll_rounds();
  if (!wait_for(connection, deadline, [&] { return socket_is_empty(connection); })) return;
  const std::uint64_t seen = rounds;
  ros::PollManager::instance()->getPollSet().signal();
  wait_for(connection, deadline, [&] { return rounds > seen; });
}

}  // namespace tzc
