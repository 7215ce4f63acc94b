// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialized_message.h>
#include <tzc/channel.h>
#include <tzc/detail/codec.h>
#include <tzc/options.h>

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>

namespace tzc {

/// A record with what the counters want to know of it. Empty when the message was dropped.
struct Shipment {
  channel::RecordPtr record;
  bool shared = false;    ///< a control part, as against a whole message
  std::size_t bytes = 0;  ///< of its control part, or of the whole message
};

/// Turns what roscpp publishes on one topic into channel records, each message once however many links send it.
/// Calls happen under Publication::subscriber_links_mutex_, except where another rule is given.
class RecordMaker {
 public:
  RecordMaker(std::shared_ptr<MemorySource> memory, OnExhausted on_exhausted)
      : memory_(std::move(memory)), on_exhausted_(on_exhausted) {}

  /// Any thread.
  void add_codec(const detail::MessageCodec& codec);
  /// Any thread.
  bool knows(const std::type_info& type) const { return find(type) != nullptr; }

  /// The record of a message published by pointer, of a known type; null when it was dropped for want of memory.
  /// Each of `links` links asks once per publish. `number` is called for the first of them: it takes the sequence
  /// number that TCPROS would give the message.
  template <class Number>
  Shipment of_pointer(const ros::SerializedMessage& message, std::size_t links, Number number) {
    if (!by_pointer_.is(message.message.get())) {
      const std::uint32_t sequence = number();
      by_pointer_.start(message.message, encode(message, sequence), links);
    }
    return by_pointer_.take();
  }
  /// The record of a message of a known type that is encoded already, with its sequence number written into it.
  Shipment of_encoded(const std::type_info& type, message::Encoded& encoded, std::uint32_t sequence) {
    return control_record(*find(type), encoded, sequence);
  }
  /// The record of a message that roscpp has serialized and numbered.
  Shipment of_bytes(const ros::SerializedMessage& message, std::size_t links);

  /// A record of this topic as TCPROS sends it. Any thread.
  ros::SerializedMessage wire_form(const channel::RecordPtr& record) const;

  /// Any thread.
  void count_sent(const Shipment& shipment) { ++(shipment.shared ? shared_ : serialized_); }
  /// A message that found no memory and was dropped before it came here. Any thread.
  void count_dropped() { ++exhausted_, ++dropped_; }
  /// Any thread.
  PublisherStatistics statistics() const;

 private:
  /// One record while the links of a topic take it. Owning the message keeps its address from naming another one.
  class Handout {
   public:
    bool is(const void* message) const { return left_ != 0 && message_.get() == message; }
    void start(boost::shared_ptr<void const> message, Shipment shipment, std::size_t links) {
      message_ = std::move(message);
      shipment_ = std::move(shipment);
      left_ = links;
    }
    Shipment take() {
      Shipment shipment = shipment_;
      if (--left_ == 0) start(nullptr, Shipment(), 0);
      return shipment;
    }

   private:
    boost::shared_ptr<void const> message_;
    Shipment shipment_;
    std::size_t left_ = 0;
  };

  const detail::MessageCodec* find(const std::type_info& type) const;
  Shipment encode(const ros::SerializedMessage& message, std::uint32_t sequence);
  Shipment control_record(const detail::MessageCodec& codec, message::Encoded& encoded,
                                    std::uint32_t sequence);
  Shipment exhausted(const detail::MessageCodec& codec, const void* message, std::uint32_t sequence);
  Shipment whole_record(const std::uint8_t* bytes, std::size_t size);

  const std::shared_ptr<MemorySource> memory_;
  const OnExhausted on_exhausted_;
  mutable std::mutex codecs_mutex_;
  std::deque<detail::MessageCodec> codecs_;  ///< only ever grows, so addresses stay valid
  Handout by_pointer_, by_bytes_;
  std::atomic<std::uint64_t> messages_{0}, shared_{0}, serialized_{0}, copied_bytes_{0}, exhausted_{0}, dropped_{0},
      control_bytes_{0};
};

}  // namespace tzc
