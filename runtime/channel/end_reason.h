// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace channel {

/// What SubscriberOptions::on_disconnect is told when the publisher has gone, or has let the subscriber go. Anything else is a fault.
constexpr char closed_by_publisher[] = "the publisher closed the connection";

/// The kernel cuts off a descriptor for which the receiving process has no room.
constexpr char lent_socket_missed[] =
    "a socket that the publisher lent did not arrive; this process may have too many files open (ulimit -n)";

/// Likewise.
constexpr char segment_files_missed[] =
    "the files of a segment did not arrive; this process may have too many files open (ulimit -n)";

}  // namespace channel
}  // namespace tzc
