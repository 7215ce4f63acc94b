// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription_callback_helper.h>
#include <tzc/detail/codec.h>

#include "roscpp/traces/traced_callback.h"

namespace tzc {
namespace detail {

/// Whether a callback may write to the very message that it is given. roscpp's isConst() does not say so for message_filters', behind
/// which there may be a writer. A callback for another C++ class gets an object of its own.
inline bool may_write(ros::SubscriptionCallbackHelper& callback, const MessageCodec& codec) {
  return callback.getTypeInfo() == *codec.type && !codec.only_reads(untraced(callback));
}

}  // namespace detail
}  // namespace tzc
