// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_options.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tzc/detail/codec.h>
#include <tzc/options.h>

#include <boost/shared_ptr.hpp>
#include <functional>
#include <memory>
#include <string>
#include <typeinfo>

namespace tzc {
namespace detail {

class Port;

/// A topic's shared-memory side, attached beside roscpp's own publisher: while it lives, subscribers of the topic that
/// can take shared memory are moved over to it. Thread-safe.
class Attachment {
 public:
  /// Null when TZC is off for this node or topic, or when the topic could not be advertised.
  /// `options.topic` as `node` was asked to advertise it, not resolved yet; the publication must already exist.
  static std::shared_ptr<Attachment> create(ros::NodeHandle& node, const ros::AdvertiseOptions& options,
                                            const MessageCodec& codec, const PublisherOptions& publisher_options);
  /// The same for a topic that other code advertised. `options.topic` is resolved already. Null also when the
  /// topic carries another type.
  static std::shared_ptr<Attachment> join(const ros::AdvertiseOptions& options, const MessageCodec& codec,
                                          const PublisherOptions& publisher_options);
  ~Attachment();
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// Messages of this type are published by pointer, too. Their header.seq counts if the topic's does.
  void add_codec(MessageCodec codec);
  bool knows(const std::type_info& type) const;

  /// Ends the attachment: no further subscriber is moved over; who was moved stays so while the topic lives. Idempotent.
  void shutdown();

  const std::shared_ptr<MemorySource>& memory() const;
  /// Somebody takes messages of this type by pointer (through shared memory or inside this process), so that building
  /// a view pays.
  bool wants_pointer(const std::type_info& type) const;
  /// Calls `publish`, which publishes by reference, unless somebody takes messages of this type by pointer: then nothing
  /// is done, and it returns false. Nobody begins to take pointers in between, so the message keeps its place before
  /// those that go by pointer.
  bool publish_by_reference(const std::type_info& type, const std::function<void()>& publish) const;
  /// The short way of a message that is encoded: straight to its subscribers, when all of them take shared memory and
  /// the topic is not latched. False: nothing was done, publish through roscpp.
  bool publish_directly(const std::type_info& type, message::Encoded& encoded);
  bool delivers_exhausted() const;
  void count_dropped();
  PublisherStatistics statistics() const;

 private:
  Attachment() = default;
  std::shared_ptr<Port> port_;
  bool has_header_ = false;
  ros::Publisher observer_;  ///< carries our connect callback; ends with this object
};

/// While it lives, this thread's publish of `message` sends `encoded` instead of encoding it once more.
class EncodedScope {
 public:
  EncodedScope(const void* message, message::Encoded& encoded);
  ~EncodedScope();
  EncodedScope(const EncodedScope&) = delete;
  EncodedScope& operator=(const EncodedScope&) = delete;

 private:
  const void* previous_message_;
  message::Encoded* previous_encoded_;
};

}  // namespace detail
}  // namespace tzc
