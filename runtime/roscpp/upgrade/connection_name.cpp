// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/connection_name.h"

#include <netinet/in.h>
#include <ros/transport/transport_tcp.h>
#include <sys/socket.h>

#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {
namespace {

using AddressOf = int (*)(int, sockaddr*, socklen_t*);

/// 0: not an internet socket, or not connected.
int port_of(int socket, AddressOf address_of) {
  sockaddr_storage address = {};
  socklen_t size = sizeof(address);
  if (address_of(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  if (address.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
  return 0;
}

}  // namespace

std::string connection_name(ros::Connection& connection, End end) {
  const auto tcp = boost::dynamic_pointer_cast<ros::TransportTCP>(connection.getTransport());
  if (!tcp) return std::string();
  const int socket = roscpp_access::sock_(*tcp);
  const int here = port_of(socket, getsockname), there = port_of(socket, getpeername);
  if (here == 0 || there == 0) return std::string();
  const int publisher = end == End::publisher ? here : there,
            subscriber = end == End::publisher ? there : here;
  return std::to_string(publisher) + "-" + std::to_string(subscriber);
}

// As long as the link refers to a connection there is no other one at its address.
ros::ConnectionPtr connection_of(ros::TransportPublisherLink& link) {
  const ros::Connection* const current = link.getConnection().get();  // one word, whatever the timer does
  ros::ConnectionManager& manager = *ros::ConnectionManager::instance();
  const boost::mutex::scoped_lock lock(roscpp_access::connections_mutex_(manager));
  for (const ros::ConnectionPtr& connection : roscpp_access::connections_(manager))
    if (connection.get() == current) return connection;
  return nullptr;
}

}  // namespace detail
}  // namespace tzc
