// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialized_message.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>
#include <tzc/options.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "roscpp/publish/control_memory.h"
#include "roscpp/publish/known_codecs.h"
#include "roscpp/publish/outgoing_message.h"
#include "roscpp/publish/publish_cache.h"
#include "roscpp/publish/serialized_arrays.h"
#include "roscpp/publish/subscriber_names.h"
#include "roscpp/throttled_warning.h"

namespace tzc {
namespace detail {

/// Like roscpp, writes the sequence number into the first four bytes of a serialized message that has a header.
void write_sequence(std::uint8_t* bytes, std::size_t size, std::uint32_t sequence);

/// Writes a sequence number into an encoded message, if messages of its topic have one.
void write_number(const MessageCodec& codec, message::Encoded& encoded, std::uint32_t sequence);

/// Whether a record can hold the message's block references and control part; otherwise the message must be
/// serialized.
bool fits_record(const message::Encoded& encoded);

/// Turns the messages of one topic into channel records, each message once, however many links send it. Calls
/// happen under Publication::subscriber_links_mutex_, except where another rule is given.
class RecordEncoder {
 public:
  RecordEncoder(std::string topic, std::shared_ptr<SegmentMemory> memory, OnExhausted on_exhausted)
      : topic_(std::move(topic)),
        memory_(std::move(memory)),
        control_memory_(memory_->options()),
        on_exhausted_(on_exhausted) {}

  OnExhausted on_exhausted() const { return on_exhausted_; }
  KnownCodecs& codecs() { return codecs_; }
  const KnownCodecs& codecs() const { return codecs_; }

  /// The record of a message of a known type that is published by pointer; null when it was dropped because
  /// no memory was left. Each of `links` links calls this once for each message. The first call calls
  /// `number`, which takes the sequence number that TCPROS would give the message.
  template <class Number>
  OutgoingMessage of_pointer(const ros::SerializedMessage& message, std::size_t links, Number number) {
    if (!by_pointer_.is(message.message.get())) {
      const std::uint32_t sequence = number();
      by_pointer_.start(message.message, unless_out_of_memory([&] { return encode(message, sequence); }),
                        links);
    }
    return by_pointer_.take();
  }
  /// The record of a message of a known type that is encoded already, with its sequence number written into it. Empty
  /// when it fits no record (fits_record()).
  OutgoingMessage of_encoded(const std::type_info& type, message::Encoded& encoded, std::uint32_t sequence) {
    return control_record(*codecs_.find(type), encoded, sequence);
  }
  /// The record of a message that roscpp has serialized and numbered.
  OutgoingMessage of_bytes(const ros::SerializedMessage& message, std::size_t links);
  /// The same for one link. Any thread.
  OutgoingMessage of_bytes_alone(const ros::SerializedMessage& message);

  /// A record of this topic as TCPROS sends it; an empty one, with a warning, where that fits no TCPROS message (4 GiB) or no memory. Any thread.
  ros::SerializedMessage to_stock_bytes(const channel::RecordPtr& record) const;

  /// Any thread.
  void count_sent(const OutgoingMessage& message) {
    ++(message.shared ? counters_.shared : counters_.serialized);
  }
  /// Counts a message that found no memory, and warns. True: it is to be dropped, as on_exhausted() says. `bytes` gives its
  /// size for the warning: to know it may mean to serialize the message. Any thread.
  bool drops_without_memory(const std::function<std::size_t()>& bytes);
  /// What `make` returns; nothing, with a warning, when the process's own memory does not suffice for it. Any thread.
  OutgoingMessage unless_out_of_memory(const std::function<OutgoingMessage()>& make);
  /// The names of the subscribers, for warnings. Any thread.
  SubscriberNames& subscribers() { return subscribers_; }
  /// Any thread.
  PublisherStatistics statistics() const;

 private:
  struct Counters {
    std::atomic<std::uint64_t> messages{0}, shared{0}, serialized{0}, copied_bytes{0}, exhausted{0},
        dropped{0}, control_bytes{0};
  };

  OutgoingMessage encode(const ros::SerializedMessage& message, std::uint32_t sequence);
  /// Empty, and nothing is counted, when the message fits no record.
  OutgoingMessage control_record(const MessageCodec& codec, message::Encoded& encoded,
                                 std::uint32_t sequence);
  OutgoingMessage too_scattered(const MessageCodec& codec, const void* message, std::uint32_t sequence,
                                std::size_t blocks);
  OutgoingMessage exhausted(const MessageCodec& codec, const void* message, std::uint32_t sequence);
  OutgoingMessage whole_record(const std::uint8_t* bytes, std::size_t size);
  void warn_exhausted(std::size_t bytes);
  OutgoingMessage inline_record(const std::uint8_t* bytes, std::size_t size);

  const std::string topic_;
  const std::shared_ptr<SegmentMemory> memory_;  ///< of arrays
  ControlMemory control_memory_;
  const OnExhausted on_exhausted_;
  SubscriberNames subscribers_;
  Throttle exhausted_warning_{std::chrono::seconds(10)};
  KnownCodecs codecs_;
  PublishCache by_pointer_, by_bytes_;
  SerializedArrays serialized_arrays_;
  Counters counters_;
};

}  // namespace detail
}  // namespace tzc
