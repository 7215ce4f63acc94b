// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>

#include <string>

namespace tzc {
namespace detail {

enum class End { publisher, subscriber };

/// Names a TCPROS connection of this network namespace by its two endpoints, alike on both of its ends; empty
/// when it is not TCP or has no peer any more. A node that leaves a topic and returns has a new one under the
/// same caller id.
std::string connection_name(ros::Connection& connection, End end);

}  // namespace detail
}  // namespace tzc
