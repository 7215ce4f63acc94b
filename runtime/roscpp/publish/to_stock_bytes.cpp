// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/to_stock_bytes.h"

#include <cstring>

#include "roscpp/upgrade/offer.h"

namespace tzc {
namespace detail {
namespace {

ros::SerializedMessage with_length(const std::uint8_t* bytes, std::size_t size) {
  const auto length = static_cast<std::uint32_t>(size);
  const boost::shared_array<std::uint8_t> buffer(new std::uint8_t[size + sizeof(length)]);
  std::memcpy(buffer.get(), &length, sizeof(length));
  std::memcpy(buffer.get() + sizeof(length), bytes, size);
  ros::SerializedMessage message(buffer, size + sizeof(length));
  message.message_start = buffer.get() + sizeof(length);
  return message;
}

ros::SerializedMessage whole_message(const channel::RecordParts& parts) {
  if (parts.blocks.empty()) return with_length(parts.control, parts.control_size);
  std::uint64_t size = 0;
  std::memcpy(&size, parts.control, sizeof(size));
  return with_length(parts.blocks.front().data, size);
}

}  // namespace

ros::SerializedMessage to_stock_bytes(const channel::RecordPtr& record, const MessageCodec& codec) {
  const channel::RecordParts parts = channel::parts_of(*record);
  if (parts.tag == kWholeMessage) return whole_message(parts);
  if (parts.tag != kControlPart) return ros::SerializedMessage();
  const boost::shared_ptr<void> view = codec.view(parts.control, parts.control_size, parts.blocks, record);
  return view ? codec.serialize(view.get()) : ros::SerializedMessage();
}

std::size_t size_of(const channel::RecordPtr& record) {
  const channel::RecordParts parts = channel::parts_of(*record);
  std::size_t size = parts.control_size;
  for (const ConstBlock& block : parts.blocks) size += block.size;
  return size;
}

}  // namespace detail
}  // namespace tzc
