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

class PublicationEndpoint;

/// What callbacks of the publisher's process get of a message that they get by pointer.
enum class LocalView {
  unseen,         ///< nothing: there are none
  borrowed,       ///< a view that must not be written to (~tzc/private_writes is off)
  private_pages,  ///< a view in which a write changes bytes of this process alone (message::callback_view)
  copy,  ///< a copy: one of them may write to it by its signature, or comes later, or they hold too much of the topic's memory
};
/// A view counts as held until `hold` is destroyed. Null: nothing is to be counted.
struct LocalMessage {
  LocalView view;
  std::shared_ptr<const void> hold;
};

/// What other threads of the process may publish while a message is published: nothing, as with roscpp, or (on any topic) what
/// they like. Then two threads that publish on one topic at once may number what callbacks of this process get alike.
enum class Others { wait, publish };

/// The shared memory of a topic, beside roscpp's own publisher. While it lives, subscribers that can use
/// shared memory are upgraded. Thread-safe.
class Attachment {
 public:
  /// Null when TZC is off for this node or topic, or when the topic could not be advertised. `options.topic`
  /// is the name that the user gave to `node`, not resolved; the publication must already exist.
  static std::shared_ptr<Attachment> create(ros::NodeHandle& node, const ros::AdvertiseOptions& options,
                                            const MessageCodec& codec,
                                            const PublisherOptions& publisher_options);
  /// That of a topic which other code advertised, made with the first call. It lasts as long as one of the program's
  /// advertisements of the topic, and does not keep the topic advertised. Null also when `topic` (resolved) carries a type of another
  /// `md5sum`, while another thread makes it, and for a while after it could not be made: a later message asks again. `codec` makes the
  /// codec of the topic's stock type.
  static std::shared_ptr<Attachment> lasting(const std::string& topic, const char* md5sum,
                                             MessageCodec (*codec)());
  /// The same for a publisher that keeps the result and does not ask again: tries at once, whatever other threads do. The options
  /// apply if the topic has no memory yet.
  static std::shared_ptr<Attachment> join(const std::string& topic, const char* md5sum,
                                          MessageCodec (*codec)(), const PublisherOptions& options);
  ~Attachment();
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// Adds a type that is published by pointer on this topic. Its header.seq is counted if the topic's is.
  void add_codec(MessageCodec codec);
  bool knows(const std::type_info& type) const;

  /// Ends the attachment: no further subscriber is upgraded; upgraded ones stay upgraded while the topic
  /// lives. Idempotent.
  void shutdown();

  const std::shared_ptr<MemorySource>& memory() const;
  /// True when a subscriber takes messages of this type by pointer (through shared memory or inside this
  /// process), so that building a view pays.
  bool wants_pointer(const std::type_info& type) const;
  /// Calls `publish`, which publishes by reference, and returns true. When a subscriber takes messages of
  /// this type by pointer it does nothing and returns false. No subscriber begins to take pointers during the
  /// call, so the message keeps its place before later ones that go by pointer.
  bool publish_by_reference(const std::type_info& type, const std::function<void()>& publish) const;
  /// Call it before roscpp publishes by pointer: what waits in roscpp's queue goes first, as it does over TCPROS.
  void send_queued();
  /// After send_queued(), calls `publish`, which publishes a view of an encoded message by pointer, in place of the program's publish by
  /// reference: roscpp's next number stands in the message before, as in what subscribers would get from roscpp.
  void publish_numbered(const std::type_info& type, message::Encoded& encoded, Others others,
                        const std::function<void()>& publish);
  /// Hot path: sends an encoded message to its subscribers past roscpp, if all of them take shared memory and
  /// the topic is not latched. False: it did nothing, publish through roscpp.
  bool publish_directly(const std::type_info& type, message::Encoded& encoded);
  /// What to make for callbacks of this process of an encoded message of this known type. Call it before each message that roscpp publishes
  /// by pointer.
  LocalMessage local_message(const std::type_info& type, const message::Encoded& encoded) const;
  bool delivers_exhausted() const;
  /// Counts a message of so many bytes that found no memory and is dropped.
  void count_dropped(std::size_t bytes);
  PublisherStatistics statistics() const;

 private:
  Attachment() = default;
  /// One that nobody makes known to subscribers yet. Null when TZC is off for this node or topic.
  static std::shared_ptr<Attachment> to(const ros::PublicationPtr& publication, const MessageCodec& codec,
                                        const PublisherOptions& publisher_options);
  static std::shared_ptr<Attachment> make_lasting(const ros::PublicationPtr& publication,
                                                  const MessageCodec& codec, const PublisherOptions& options);
  /// Has `attachment` owned by an advertisement of the publication, whose subscribers it is told of.
  static void hand_over(const ros::PublicationPtr& publication,
                        const std::shared_ptr<Attachment>& attachment);

  std::shared_ptr<PublicationEndpoint> endpoint_;
  bool has_header_ = false;
  ros::Publisher
      observer_;  ///< has TZC's connect callback; ends with this object; empty: the advertisement of other code has it
};

/// The connect callback, whose SingleSubscriberPublisher reaches the subscriber also after it has moved to shared memory, in order
/// with what is published to all. An empty callback stays empty.
ros::SubscriberStatusCallback on_current_link(const ros::SubscriberStatusCallback& callback);

/// Shared memory for messages that are allocated from a publisher which is not advertised: others of this process publish them
/// without a copy. Null until a topic of this process has shared memory, and when there is none left. Thread-safe.
std::shared_ptr<MemorySource> memory_of_no_topic();

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
