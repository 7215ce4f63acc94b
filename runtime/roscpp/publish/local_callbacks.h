// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <tzc/detail/attachment.h>
#include <tzc/detail/codec.h>

namespace tzc {
namespace detail {

/// How callbacks of this process may see a message of type `codec.type` that the publication passes to them by pointer; those
/// that may have a view of it are made ready for faults (fault_ready_queue.h). Call it before each such message. Takes
/// subscriber_links_mutex_ and the subscriptions' callbacks_mutex_, briefly.
LocalView prepare_local_callbacks(ros::Publication& publication, const MessageCodec& codec);

}  // namespace detail
}  // namespace tzc
