// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>

namespace tzc {
namespace detail {

/// Sends what waits in roscpp's queue of serialized messages, as roscpp's poll thread does in Publication::enqueueMessage
/// (publication.cpp), but on the caller's thread. The caller holds advertised_topics_mutex_, so that neither that thread sends from the
/// queue nor a link moves, and no mutex of the publication.
///
/// A TCPROS link gets its messages without subscriber_links_mutex_. For them it takes its connection's TransportTCP::close_mutex_, which
/// the poll thread holds when the connection has ended and its link is to leave the publication, for which it needs
/// subscriber_links_mutex_: with both, the two threads would wait for each other for ever.
void send_queue(ros::Publication& publication);

}  // namespace detail
}  // namespace tzc
