// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/record_maker.h"

#include <tzc/detail/attachment.h>

#include <algorithm>
#include <cstring>

#include "roscpp/offer.h"
#include "roscpp/wire_form.h"

namespace tzc {
namespace {

/// Whole messages above this size go through a block: one copy instead of a chain of fragments in the socket.
constexpr std::size_t kInlineLimit = 32 * 1024;

thread_local const void* scoped_message = nullptr;
thread_local message::Encoded* scoped_encoded = nullptr;

/// roscpp numbers a message in its first four bytes after serializing it; so do we.
void write_sequence(std::uint8_t* bytes, std::size_t size, std::uint32_t sequence) {
  if (size >= sizeof(sequence)) std::memcpy(bytes, &sequence, sizeof(sequence));
}

}  // namespace

namespace detail {

EncodedScope::EncodedScope(const void* message, message::Encoded& encoded)
    : previous_message_(scoped_message), previous_encoded_(scoped_encoded) {
  scoped_message = message;
  scoped_encoded = &encoded;
}

EncodedScope::~EncodedScope() {
  scoped_message = previous_message_;
  scoped_encoded = previous_encoded_;
}

}  // namespace detail

void RecordMaker::add_codec(const detail::MessageCodec& codec) {
  if (knows(*codec.type)) return;
  const std::lock_guard<std::mutex> lock(codecs_mutex_);
  codecs_.push_back(codec);
}

const detail::MessageCodec* RecordMaker::find(const std::type_info& type) const {
  const std::lock_guard<std::mutex> lock(codecs_mutex_);
  const auto found = std::find_if(codecs_.begin(), codecs_.end(),
                                  [&](const detail::MessageCodec& codec) { return *codec.type == type; });
  return found == codecs_.end() ? nullptr : &*found;
}

Shipment RecordMaker::encode(const ros::SerializedMessage& message, std::uint32_t sequence) {
  const detail::MessageCodec& codec = *find(*message.type_info);
  const void* address = message.message.get();
  if (scoped_encoded && scoped_message == address) return control_record(codec, *scoped_encoded, sequence);
  message::Encoded encoded;
  if (!codec.encode(address, *memory_, encoded)) return exhausted(codec, address, sequence);
  return control_record(codec, encoded, sequence);
}

Shipment RecordMaker::control_record(const detail::MessageCodec& codec, message::Encoded& encoded,
                                               std::uint32_t sequence) {
  std::vector<std::uint8_t>& control = encoded.control;
  if (codec.has_header) write_sequence(control.data(), control.size(), sequence);
  ++messages_;
  copied_bytes_ += encoded.copied_bytes;
  control_bytes_ += control.size();
  return {channel::make_record(kControlPart, control.data(), control.size(), encoded.buffers, memory_.get()), true,
          control.size()};
}

Shipment RecordMaker::exhausted(const detail::MessageCodec& codec, const void* message,
                                          std::uint32_t sequence) {
  ++exhausted_;
  if (on_exhausted_ == OnExhausted::drop) {
    ++dropped_;
    return Shipment();
  }
  const ros::SerializedMessage bytes = codec.serialize(message);
  std::uint8_t* start = bytes.message_start;
  const std::size_t size = bytes.num_bytes - (start - bytes.buf.get());
  if (codec.has_header) write_sequence(start, size, sequence);
  return {channel::make_record(kWholeMessage, start, size), false, size};
}

Shipment RecordMaker::whole_record(const std::uint8_t* bytes, std::size_t size) {
  if (size > kInlineLimit) {
    if (const BufferPtr block = memory_->allocate(size)) {
      std::memcpy(block->data(), bytes, size);
      copied_bytes_ += size;
      const std::uint64_t used = size;  // blocks are rounded up
      return {channel::make_record(kWholeMessage, &used, sizeof(used), {block}), false, size};
    }
    ++exhausted_;
  }
  return {channel::make_record(kWholeMessage, bytes, size), false, size};
}

Shipment RecordMaker::of_bytes(const ros::SerializedMessage& message, std::size_t links) {
  if (!by_bytes_.is(message.buf.get())) {
    const std::size_t length_prefix = 4;
    const boost::shared_ptr<void const> owner(message.buf.get(), [keep = message.buf](const void*) {});
    by_bytes_.start(owner, whole_record(message.buf.get() + length_prefix, message.num_bytes - length_prefix), links);
  }
  return by_bytes_.take();
}

ros::SerializedMessage RecordMaker::wire_form(const channel::RecordPtr& record) const {
  const std::lock_guard<std::mutex> lock(codecs_mutex_);
  return codecs_.empty() ? ros::SerializedMessage() : tzc::wire_form(record, codecs_.front());
}

PublisherStatistics RecordMaker::statistics() const {
  PublisherStatistics statistics;
  statistics.messages = messages_;
  statistics.shared = shared_;
  statistics.serialized = serialized_;
  statistics.copied_bytes = copied_bytes_;
  statistics.exhausted = exhausted_;
  statistics.dropped = dropped_;
  statistics.control_bytes = control_bytes_;
  return statistics;
}

}  // namespace tzc
