// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace channel {

/// What SubscriberOptions::on_disconnect is told when the publisher has gone, or has let the subscriber go. Anything else is a fault.
constexpr char closed_by_publisher[] = "the publisher closed the connection";

}  // namespace channel
}  // namespace tzc
