// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/parked_link.h"

#include <linux/sockios.h>
#include <ros/connection.h>
#include <ros/transport/transport_tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>

#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {

namespace access = roscpp_access;

namespace {

/// Null for another transport than TCP.
ros::TransportTCPPtr tcp_of(ros::TransportSubscriberLink& link) {
  return boost::dynamic_pointer_cast<ros::TransportTCP>(link.getConnection()->getTransport());
}

}  // namespace

bool is_drained(ros::TransportSubscriberLink& link) {
  {
    const boost::mutex::scoped_lock lock(access::outbox_mutex_(link));
    const bool idle = access::outbox_(link).empty() && !access::writing_message_(link);
    if (!idle || !access::header_written_(link)) return false;
  }
  const ros::TransportTCPPtr tcp = tcp_of(link);
  int unacknowledged = 0;
  return !tcp || ioctl(access::sock_(*tcp), SIOCOUTQ, &unacknowledged) != 0 || unacknowledged == 0;
}

bool has_room(ros::TransportSubscriberLink& link, std::size_t queue_size) {
  const boost::mutex::scoped_lock lock(access::outbox_mutex_(link));
  return queue_size == 0 || access::outbox_(link).size() < queue_size;
}

bool peer_is_gone(ros::TransportSubscriberLink& link) {
  const ros::TransportTCPPtr tcp = tcp_of(link);
  if (!tcp || link.getConnection()->isDropped()) return true;
  char byte = 0;
  const ssize_t size = recv(access::sock_(*tcp), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return size == 0 || (size < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

}  // namespace detail
}  // namespace tzc
