// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/tcpros_drain.h"

#include <sys/ioctl.h>

#include <chrono>
#include <thread>

#include "roscpp/before_exit.h"
#include "roscpp/roscpp_access.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

bool socket_is_empty(ros::Connection& connection) {
  const auto tcp = boost::dynamic_pointer_cast<ros::TransportTCP>(connection.getTransport());
  int unread = 0;
  return !tcp || ioctl(roscpp_access::sock_(*tcp), FIONREAD, &unread) != 0 || unread == 0;
}

}  // namespace

bool TcprosDrain::is_over(ros::Connection& connection) {
  const Clock::time_point now = Clock::now();
  // A process that is stopped is asked again when it goes on, and its reading thread has not had that time.
  if (now - last_look_ > std::chrono::seconds(1)) deadline_ = now + std::chrono::seconds(5);
  last_look_ = now;
  if (!socket_is_empty(connection)) return connection.isDropped() || now > deadline_;
  // The reading thread (not always the poll thread) holds this mutex until it has passed on what it read.
  sync_point("switch: waits for the reader");
  const boost::unique_lock<boost::recursive_mutex> lock(roscpp_access::read_mutex_(connection),
                                                        boost::try_to_lock);
  if (!lock.owns_lock()) return false;
  sync_point("switch: the reader is done");
  return true;
}

void TcprosDrain::wait(ros::Connection& connection) {
  while (!is_over(connection) && !exit_has_begun())
    std::this_thread::sleep_for(std::chrono::microseconds(200));
}

}  // namespace detail
}  // namespace tzc
