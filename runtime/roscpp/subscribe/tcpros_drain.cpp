// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/tcpros_drain.h"

#include <sys/ioctl.h>

#include <chrono>
#include <thread>

#include "roscpp/roscpp_access.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

using Clock = std::chrono::steady_clock;

bool socket_is_empty(ros::Connection& connection) {
  const auto tcp = boost::dynamic_pointer_cast<ros::TransportTCP>(connection.getTransport());
  int unread = 0;
  return !tcp || ioctl(roscpp_access::sock_(*tcp), FIONREAD, &unread) != 0 || unread == 0;
}

bool wait_until_empty(ros::Connection& connection, Clock::time_point deadline) {
  while (!socket_is_empty(connection)) {
    if (connection.isDropped() || Clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace

void wait_until_drained(ros::Connection& connection) {
  if (!wait_until_empty(connection, Clock::now() + std::chrono::seconds(5))) return;
  // The reading thread (not always the poll thread) holds this mutex until it has passed on what it read.
  sync_point("switch: waits for the reader");
  const boost::recursive_mutex::scoped_lock lock(roscpp_access::read_mutex_(connection));
  sync_point("switch: the reader is done");
}

}  // namespace detail
}  // namespace tzc
