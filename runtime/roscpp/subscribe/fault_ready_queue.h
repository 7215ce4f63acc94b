// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/subscription.h>
#include <tzc/detail/codec.h>

namespace tzc {
namespace detail {

/// Sees to it that each callback of the subscription is called on a thread that does not block the signals of faults and with
/// TZC's handler as the first one, whatever queue it waits in and whoever calls that: roscpp's spinners with threads of their own
/// block all signals, and other code may have installed a handler since the message was taken. A callback that writes to a shared
/// message there would end the process. Any thread; call it before each message.
/// @return whether a callback of the subscription may write to the codec's messages.
bool make_ready_for_faults(ros::Subscription& subscription, const MessageCodec& codec);

/// Whether callbacks that are added to `queue` are called by who calls those of `other`.
bool leads_to(const ros::CallbackQueueInterface& queue, const ros::CallbackQueueInterface& other);

}  // namespace detail
}  // namespace tzc
