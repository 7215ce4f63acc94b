// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_options.h>
#include <tzc/detail/codec.h>

#include <string>

namespace tzc {
namespace detail {

/// Prepares an advertisement of other code for shared memory: adds a connect callback to `options`, which name the queue of the user's
/// callbacks, before those. It attaches the topic when the first subscriber connects, also when the program does not call that
/// queue. The attachment ends with the advertisement. Does nothing when TZC is off for the topic.
void hook_advertisement(const std::string& resolved_topic, const MessageCodec& codec,
                        ros::AdvertiseOptions& options);

}  // namespace detail
}  // namespace tzc
