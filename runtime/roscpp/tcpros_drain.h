// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/connection.h>

namespace tzc {

/// Blocks until every message that has reached this TCPROS connection was handed to its subscription (or the
/// connection was dropped, or 5 s have passed). The publisher has made sure that nothing is on its way any more.
/// Reader thread only.
void wait_until_drained(ros::Connection& connection);

}  // namespace tzc
