// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/subscription.h>
#include <tzc/detail/codec.h>

namespace tzc {
namespace detail {

/// A queue that adds to `queue` what it is given, ready for faults (fault_ready_callback.h), whoever calls that. `queue` itself if it
/// does so: roscpp's global one where it is TZC's (heard_queue.h), and the one of direct callbacks, whose threads are TZC's. Any thread.
ros::CallbackQueueInterface* fault_ready_queue(ros::CallbackQueueInterface& queue);

/// Sees to it that each callback of the subscription that is queued from now on is ready for faults. Any thread; call it before each
/// message.
/// @return whether a callback of the subscription may write to the codec's messages.
bool make_ready_for_faults(ros::Subscription& subscription, const MessageCodec& codec);

/// The same for all subscriptions of this process, of any type, since a callback may write to a message that another one has kept. False:
/// not for all, as some are in use for the moment. Waits for nothing.
bool try_make_all_ready_for_faults();

/// From now on roscpp's poll thread does so before each round: a subscription that comes later is ready before its first connection is
/// read. Waits for that thread, which may wait for a thread that publishes; the caller must hold no lock of roscpp's.
void keep_all_ready_for_faults();

/// Whether callbacks that are added to `queue` are called by who calls those of `other`.
bool leads_to(const ros::CallbackQueueInterface& queue, const ros::CallbackQueueInterface& other);

}  // namespace detail
}  // namespace tzc
