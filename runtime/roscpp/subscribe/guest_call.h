// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "roscpp/spin/heard_queue.h"
#include "roscpp/subscribe/direct_call.h"

namespace tzc {
namespace detail {

/// On the thread that reads as the guest of `queue` (tzc::spin): the callback of a message that was read is called there as soon as
/// it reads no longer, as the queue's next one, without having been in it. Order, thread and locks are those of the way
/// through the queue.
/// @param decode is called before this returns, or not at all
/// @return false: it did nothing. The guest has such a call already, something waits before the message, or DirectCall says so.
bool leave_to_guest(HeardQueue& queue, ros::Subscription& subscription, const DirectMessage& message,
                    const Decode& decode);

}  // namespace detail
}  // namespace tzc
