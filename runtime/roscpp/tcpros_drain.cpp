// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/tcpros_drain.h"

#include <sys/ioctl.h>

#include <chrono>
#include <thread>

#include "posix/step.h"
#include "roscpp/roscpp_access.h"

namespace tzc {
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
  // Whoever reads, and that is not always the poll thread, holds this from before it reads until what it read
  // has been handed over.
  posix::step("switch: waits for the reader");
  const boost::recursive_mutex::scoped_lock lock(roscpp_access::read_mutex_(connection));
  posix::step("switch: the reader is done");
}

}  // namespace tzc
