// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_options.h>
#include <tzc/detail/codec.h>

#include <string>

namespace tzc {
namespace detail {

/// Prepares an advertisement that somebody else makes and owns for shared memory: hooks a connect callback into
/// `options`, in front of the user's, which then attaches the topic when its first subscriber comes. The attachment
/// ends with the advertisement. Does nothing when TZC is off for the topic.
void hook_advertisement(const std::string& resolved_topic, const MessageCodec& codec, ros::AdvertiseOptions& options);

}  // namespace detail
}  // namespace tzc
