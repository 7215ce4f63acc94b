// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>

namespace tzc {
namespace detail {

/// Blocks until the subscription has got every message that reached this TCPROS connection (or the connection
/// was dropped, or 5 s have passed). The publisher has stopped sending on it before. Reader thread only.
void wait_until_drained(ros::Connection& connection);

}  // namespace detail
}  // namespace tzc
