// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>
#include <ros/transport_publisher_link.h>

#include <string>

namespace tzc {
namespace detail {

enum class End { publisher, subscriber };

/// Names a TCPROS connection of this network namespace by its two endpoints, alike on both of its ends; empty
/// when it is not TCP or has no peer any more. A node that leaves a topic and returns has a new one under the
/// same caller id.
std::string connection_name(ros::Connection& connection, End end);

/// The connection of a link; null when roscpp has dropped it, or has not noted it yet. Not a copy of the link's own pointer, which
/// roscpp's timer replaces without a lock when it connects again. Any thread.
ros::ConnectionPtr connection_of(ros::TransportPublisherLink& link);

}  // namespace detail
}  // namespace tzc
