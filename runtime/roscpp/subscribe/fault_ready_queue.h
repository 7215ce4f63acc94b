// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription.h>

namespace tzc {
namespace detail {

/// Sees to it that the callbacks of the subscription are called on threads that do not block the signals of faults, whatever
/// queue they wait in and whoever calls that: roscpp's spinners with threads of their own block all signals, and a callback
/// that writes to a shared message there would end the process. Any thread; call it before each message.
/// @return whether a callback of the subscription may write to messages.
bool make_ready_for_faults(ros::Subscription& subscription);

}  // namespace detail
}  // namespace tzc
