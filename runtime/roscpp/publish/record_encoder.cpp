// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/record_encoder.h"

#include <tzc/detail/attachment.h>
#include <tzc/guard.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include "roscpp/publish/exhaustion_report.h"
#include "roscpp/publish/to_stock_bytes.h"
#include "roscpp/throttled_warning.h"
#include "roscpp/upgrade/offer.h"

namespace tzc {
namespace detail {
namespace {

/// Whole messages above this size (bytes) go through a block: one copy instead of a chain of fragments in the
/// socket.
constexpr std::size_t kInlineLimit = 32 * 1024;

/// What channel::make_record takes.
constexpr std::size_t kMostBlocks = 4096;
constexpr std::size_t kMostControlBytes = std::size_t{1} << 30;

thread_local const void* scoped_message = nullptr;
thread_local message::Encoded* scoped_encoded = nullptr;

/// What roscpp wrote there, if the message has a header.
std::uint32_t read_sequence(const std::uint8_t* bytes) {
  std::uint32_t sequence;
  std::memcpy(&sequence, bytes, sizeof sequence);
  return sequence;
}

/// The message as TCPROS sends it, without the length in front.
ros::SerializedMessage numbered_bytes(const MessageCodec& codec, const void* message,
                                      std::uint32_t sequence) {
  ros::SerializedMessage bytes = codec.serialize(message);
  bytes.num_bytes -= static_cast<std::size_t>(bytes.message_start - bytes.buf.get());
  if (codec.has_header) write_sequence(bytes.message_start, bytes.num_bytes, sequence);
  return bytes;
}

}  // namespace

void write_sequence(std::uint8_t* bytes, std::size_t size, std::uint32_t sequence) {
  if (size >= sizeof(sequence)) std::memcpy(bytes, &sequence, sizeof(sequence));
}

EncodedScope::EncodedScope(const void* message, message::Encoded& encoded)
    : previous_message_(scoped_message), previous_encoded_(scoped_encoded) {
  scoped_message = message;
  scoped_encoded = &encoded;
}

EncodedScope::~EncodedScope() {
  scoped_message = previous_message_;
  scoped_encoded = previous_encoded_;
}

void write_number(const MessageCodec& codec, message::Encoded& encoded, std::uint32_t sequence) {
  if (codec.has_header) write_sequence(encoded.control.data(), encoded.control.size(), sequence);
}

OutgoingMessage RecordEncoder::unless_out_of_memory(const std::function<OutgoingMessage()>& make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    ++counters_.dropped;
    TZC_WARN_THROTTLED_FOR(
        topic_, 10,
        "TZC: " << topic_ << ": a message is dropped for subscribers on shared memory: neither the "
                << "shared memory nor the process's own has room for it (ulimit -v, a container's limit)");
    return OutgoingMessage();
  }
}

OutgoingMessage RecordEncoder::encode(const ros::SerializedMessage& message, std::uint32_t sequence) {
  const MessageCodec& codec = *codecs_.find(*message.type_info);
  const void* address = message.message.get();
  message::Encoded own;
  const bool is_encoded = scoped_encoded && scoped_message == address;
  if (!is_encoded && !codec.encode(address, memory_, own)) return exhausted(codec, address, sequence);
  message::Encoded& encoded = is_encoded ? *scoped_encoded : own;
  return fits_record(encoded) ? control_record(codec, encoded, sequence)
                              : too_scattered(codec, address, sequence, encoded.buffers.size());
}

bool fits_record(const message::Encoded& encoded) {
  return encoded.buffers.size() <= kMostBlocks && encoded.control.size() <= kMostControlBytes;
}

OutgoingMessage RecordEncoder::too_scattered(const MessageCodec& codec, const void* message,
                                             std::uint32_t sequence, std::size_t blocks) {
  TZC_WARN_THROTTLED_FOR(
      topic_, 60,
      "TZC: " << topic_ << ": a message is sent serialized: its arrays lie in " << blocks << " blocks ("
              << kMostBlocks << " blocks are the most), or its other fields take more than 1 GiB; call "
              << "allocate once the sizes of its arrays are set, which gives all of them one block");
  const ros::SerializedMessage bytes = numbered_bytes(codec, message, sequence);
  return whole_record(bytes.message_start, bytes.num_bytes);
}

OutgoingMessage RecordEncoder::control_record(const MessageCodec& codec, message::Encoded& encoded,
                                              std::uint32_t sequence) {
  const std::vector<std::uint8_t>& control = encoded.control;
  write_number(codec, encoded, sequence);
  const guard::MessageNumber number(sequence);
  ++counters_.messages;
  counters_.copied_bytes += encoded.copied_bytes;
  counters_.control_bytes += control.size();
  return {
      channel::make_record(kControlPart, control.data(), control.size(), encoded.buffers, &control_memory_),
      true, control.size()};
}

bool RecordEncoder::drops_without_memory(const std::function<std::size_t()>& bytes) {
  ++counters_.exhausted;
  const bool warns = exhausted_warning_.is_due();
  const std::size_t size =
      warns ? bytes() : 0;  // may throw, and then the message is counted as dropped elsewhere
  const bool is_dropped = on_exhausted_ == OnExhausted::drop;
  if (is_dropped) ++counters_.dropped;
  if (warns) warn_exhausted(size);
  return is_dropped;
}

OutgoingMessage RecordEncoder::exhausted(const MessageCodec& codec, const void* message,
                                         std::uint32_t sequence) {
  if (drops_without_memory([&] { return codec.serialize(message).num_bytes; })) return OutgoingMessage();
  const ros::SerializedMessage bytes = numbered_bytes(codec, message, sequence);
  return inline_record(bytes.message_start, bytes.num_bytes);
}

OutgoingMessage RecordEncoder::whole_record(const std::uint8_t* bytes, std::size_t size) {
  if (size <= kInlineLimit) return inline_record(bytes, size);
  if (const BufferPtr block = memory_->allocate(size)) {
    std::memcpy(block->data(), bytes, size);
    counters_.copied_bytes += size;
    const std::uint64_t used = size;  // blocks are rounded up
    return {channel::make_record(kWholeMessage, &used, sizeof(used), {block}), false, size};
  }
  return drops_without_memory([&] { return size; }) ? OutgoingMessage() : inline_record(bytes, size);
}

// A message that fits no record (over 1 GiB and without shared memory) is lost, as over TCPROS, which ends
// the connection.
OutgoingMessage RecordEncoder::inline_record(const std::uint8_t* bytes, std::size_t size) {
  const channel::RecordPtr record = channel::make_record(kWholeMessage, bytes, size);
  if (!record) {
    ++counters_.dropped;
    TZC_WARN_THROTTLED_FOR(topic_, 10,
                           "TZC: " << topic_ << ": a message of " << size
                                   << " bytes is dropped: it fits neither the shared memory nor a socket");
  }
  return {record, false, size};
}

OutgoingMessage RecordEncoder::of_bytes(const ros::SerializedMessage& message, std::size_t links) {
  if (by_bytes_.is(message.buf.get())) return by_bytes_.take();
  const boost::shared_ptr<void const> owner(message.buf.get(), [keep = message.buf](const void*) {});
  by_bytes_.start(owner, of_bytes_alone(message), links);
  return by_bytes_.take();
}

// Of a message that is not small, subscribers read the arrays where they lie, as if it had been published by pointer.
OutgoingMessage RecordEncoder::of_bytes_alone(const ros::SerializedMessage& message) {
  const std::size_t length_prefix = 4;
  const std::uint8_t* const bytes = message.buf.get() + length_prefix;
  const std::size_t size = message.num_bytes - length_prefix;
  return unless_out_of_memory([&] {
    const MessageCodec* const codec = codecs_.first();
    message::Encoded encoded;
    const bool is_shared = size > kInlineLimit && codec &&
                           serialized_arrays_.encode(*codec, bytes, size, memory_, encoded) &&
                           fits_record(encoded);
    return is_shared ? control_record(*codec, encoded, read_sequence(bytes)) : whole_record(bytes, size);
  });
}

ros::SerializedMessage RecordEncoder::to_stock_bytes(const channel::RecordPtr& record) const {
  const MessageCodec* const codec = codecs_.first();
  try {
    return codec ? detail::to_stock_bytes(record, *codec) : ros::SerializedMessage();
  } catch (const ros::Exception& error) {
    TZC_WARN_THROTTLED_FOR(topic_, 10, "TZC: " << topic_ << ": a message is dropped: " << error.what());
  } catch (const std::bad_alloc&) {
    TZC_WARN_THROTTLED_FOR(topic_, 10,
                           "TZC: " << topic_ << ": a message that goes back to TCPROS is dropped: no memory");
  }
  return ros::SerializedMessage();
}

// A process without descriptors has none for any of its topics, so one warning speaks for all of them.
void RecordEncoder::warn_exhausted(std::size_t bytes) {
  const AllocationError failure = memory_->last_failure();
  if (failure.code == EMFILE || failure.code == ENFILE) {
    TZC_WARN_THROTTLED(60,
                       "TZC: " << topic_ << " and other topics: no shared memory (" << failure.text() << ")");
    return;
  }
  const Exhaustion what{topic_, bytes, on_exhausted_,
                        on_exhausted_ == OnExhausted::drop ? counters_.dropped : counters_.exhausted,
                        subscribers_.in_flight()};
  ROS_WARN_STREAM("TZC: " << exhaustion_report(what, memory_->options(), memory_->stats(), failure));
}

PublisherStatistics RecordEncoder::statistics() const {
  PublisherStatistics statistics;
  statistics.messages = counters_.messages;
  statistics.shared = counters_.shared;
  statistics.serialized = counters_.serialized;
  statistics.copied_bytes = counters_.copied_bytes + memory_->copied_bytes();
  statistics.exhausted = counters_.exhausted;
  statistics.dropped = counters_.dropped;
  statistics.control_bytes = counters_.control_bytes;
  return statistics;
}

}  // namespace detail
}  // namespace tzc
