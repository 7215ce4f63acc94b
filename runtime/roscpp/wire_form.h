// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialized_message.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>

namespace tzc {

/// A record as TCPROS sends it: the stock wire format with its length in front, header.seq as it was given.
/// Empty (no buffer) when the record carries no message.
/// @param codec one of the record's topic
ros::SerializedMessage wire_form(const channel::RecordPtr& record, const detail::MessageCodec& codec);

/// Bytes of all that the record keeps alive.
std::size_t size_of(const channel::RecordPtr& record);

}  // namespace tzc
