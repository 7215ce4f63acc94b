// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialized_message.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>

namespace tzc {
namespace detail {

/// A record as TCPROS sends it: the stock wire format with its length in front, header.seq as it was given.
/// Empty (no buffer) when the record carries no message.
/// @param codec one of the record's topic
ros::SerializedMessage to_stock_bytes(const channel::RecordPtr& record, const MessageCodec& codec);

/// The bytes of all blocks and bodies that the record keeps alive.
std::size_t size_of(const channel::RecordPtr& record);

}  // namespace detail
}  // namespace tzc
