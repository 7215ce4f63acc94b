// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/transport_subscriber_link.h>

#include <cstddef>

namespace tzc {
namespace detail {

// The state of a TCPROS link that is parked in a SharedLink. Any thread.

/// True when the subscriber's kernel has acknowledged everything that was given to the link.
bool is_drained(ros::TransportSubscriberLink& link);

/// True while fewer than `queue_size` messages (0: any number) wait in the link's outbox.
bool has_room(ros::TransportSubscriberLink& link, std::size_t queue_size);

/// True when the connection is dropped or its other end is closed.
bool peer_is_gone(ros::TransportSubscriberLink& link);

}  // namespace detail
}  // namespace tzc
