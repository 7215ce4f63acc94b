// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <tzc/credentials.h>
#include <tzc/error.h>
#include <tzc/memory.h>

// Publish and subscribe between processes of one machine, without ROS.
//
//   Publisher --listens--> address <--connects-- Subscriber
//       |                                            ^
//       |  publish(record): blocks stay in place     |  on_message(message): the same bytes, mapped read-only
//       +------> Connection, one a subscriber -------+
//                (control part over a seqpacket socket, memory files as passed descriptors)

namespace tzc {
namespace channel {

/// A message ready to be sent: control part and blocks. Immutable, prepared once, sent to many; any thread.
/// It keeps its buffers alive until the last queue that holds it is done with it.
class Record;
using RecordPtr = std::shared_ptr<const Record>;

/// Copies the control part and seals the buffers. `tag` is the application's, handed through unchanged.
/// A control part over 64 KB goes into a block of `memory` when that is given and not exhausted, otherwise it
/// travels as fragments over the socket. Null when a buffer is null, or for more than 4096 buffers.
RecordPtr make_record(std::uint32_t tag, const void* control, std::size_t control_size,
                      BufferSpan buffers = {}, MemorySource* memory = nullptr);

/// What a record says. Valid for as long as the record lives.
struct RecordParts {
  std::uint32_t tag;
  const std::uint8_t* control;
  std::size_t control_size;
  std::vector<ConstBlock> blocks;
};
RecordParts parts_of(const Record& record);

/// Counters of one subscriber, seen from the publisher. A record counts as dropped when it left the queue
/// unread: the queue was full, the memory was needed (best_effort), or the subscriber went.
struct ConnectionStats {
  std::uint64_t sent = 0;     ///< records accepted by send()
  std::uint64_t dropped = 0;  ///< of those, revoked before the subscriber took them
  std::uint64_t bytes = 0;    ///< written to the socket
  std::size_t queued = 0;     ///< now waiting in this process because the socket is full
  std::size_t in_flight = 0;  ///< now sent and not taken yet (includes queued)
};

/// The publisher's side of one subscriber. Thread-safe.
class Connection {
 public:
  virtual ~Connection() = default;
  virtual Credentials peer() const = 0;
  /// What the subscriber said about itself when it connected (SubscriberOptions::hello). Not trusted.
  virtual const std::string& hello() const = 0;
  /// False once the subscriber unsubscribed, died or was closed.
  virtual bool alive() const = 0;
  /// Never blocks: writes directly, or queues when the socket is full. At most queue_size records are
  /// untaken; beyond that the oldest is revoked and counted. False when the connection is not alive, or when
  /// the record's memory could not be offered to this subscriber (alive() stays true, last_failure() says
  /// why: send the message without shared memory instead).
  virtual bool send(const RecordPtr& record) = 0;
  virtual Error last_failure() const = 0;
  /// Ends the subscription. Records already sent still arrive; blocks that the subscriber holds stay valid.
  virtual void close() = 0;
  virtual ConnectionStats stats() const = 0;
  /// Records that were sent and that the subscriber has not taken yet.
  virtual std::size_t untaken() = 0;
  /// After the end, with PublisherOptions::keeps_undelivered: the records that were sent and not taken,
  /// oldest first, but for those that the queue or a policy revoked. The subscriber will never take them.
  /// Gives each of them once.
  virtual std::vector<RecordPtr> take_undelivered() = 0;
};
using ConnectionPtr = std::shared_ptr<Connection>;

struct PublisherOptions {
  /// Empty: an abstract name with a 128-bit nonce (a pathname in the portable build). "@name": that abstract
  /// name. Otherwise a pathname, at most 107 bytes; a leftover socket nobody listens on is replaced.
  std::string address{};
  /// Most records that may be untaken for each subscriber; 0: as many as the protocol can count (65535).
  std::size_t queue_size = 10;
  /// Shared by several publishers if you like. Null: created with its default options for this queue size.
  std::shared_ptr<SegmentMemory> memory{};
  /// Keeps what a subscriber had not taken when its connection ended, for Connection::take_undelivered().
  bool keeps_undelivered = false;
  /// Asked on the service thread for each subscriber. Null: only processes of the same user.
  std::function<bool(const Credentials&, const std::string& hello)> authorize{};
  /// Called on the service thread, before the subscriber is told that it is accepted: what is sent here comes
  /// first. Neither may block for long: one thread serves all publishers of the process.
  std::function<void(const ConnectionPtr&)> on_connect{};
  /// Called once for each connection that on_connect saw, when the subscriber unsubscribed or died.
  std::function<void(const ConnectionPtr&)> on_disconnect{};
};

struct PublisherStats {
  std::uint64_t published = 0;        ///< publish() calls
  std::uint64_t sent = 0;             ///< records accepted for some subscriber, summed
  std::uint64_t dropped = 0;          ///< records revoked before their subscriber took them, summed
  std::uint64_t refused_peers = 0;    ///< not authorized, or not speaking this protocol
  std::uint64_t accept_failures = 0;  ///< connections that failed here, e.g. too many open files
  std::size_t subscribers = 0;        ///< alive now
};

/// Listens for subscribers and sends them records. Thread-safe. The end of the last shared_ptr waits for a
/// callback that is running, unless it happens inside one: hold no lock then that a callback takes.
/// Afterwards no callback runs any more; what is queued for live subscribers is still tried for up to a
/// second.
class Publisher {
 public:
  virtual ~Publisher() = default;
  /// Errors: the address is taken or too long, no descriptors left.
  static Expected<std::shared_ptr<Publisher>> create(PublisherOptions options);
  /// What subscribers connect to.
  virtual const std::string& address() const = 0;
  virtual const std::shared_ptr<SegmentMemory>& memory() const = 0;
  /// Sends to every live subscriber; how many accepted it. Never blocks.
  virtual std::size_t publish(const RecordPtr& record) = 0;
  virtual std::vector<ConnectionPtr> connections() const = 0;
  virtual PublisherStats stats() const = 0;
};

/// A received record. Immutable. Until it is destroyed its blocks belong to this process (the publisher can't
/// reuse them, even after unsubscribing) and the connection's socket stays open. A forked child may read it
/// while its parent holds it, and may destroy its copy freely.
class Message {
 public:
  virtual ~Message() = default;
  std::uint32_t tag() const noexcept { return tag_; }
  /// Aligned to 8 bytes.
  const std::uint8_t* control() const noexcept { return control_; }
  std::size_t control_size() const noexcept { return control_size_; }
  const std::vector<ConstBlock>& blocks() const noexcept { return blocks_; }

 protected:
  Message() = default;
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;
  std::uint32_t tag_ = 0;
  const std::uint8_t* control_ = nullptr;
  std::size_t control_size_ = 0;
  std::vector<ConstBlock> blocks_;
};
using MessagePtr = std::shared_ptr<const Message>;

struct SubscriberOptions {
  std::string address{};  ///< as Publisher::address()
  std::string hello{};    ///< handed to the publisher's authorize and on_connect; at most 32 KB
  /// True: a thread of its own reads and calls on_message. False: the caller waits on fd() and calls read().
  bool own_thread = true;
  std::function<void(const MessagePtr&)> on_message{};
  /// Called once when the publisher went or broke the protocol; the reason is for people.
  std::function<void(const std::string& reason)> on_disconnect{};
  /// Asked about the publisher before anything is sent to it. Null: only a process of the same user, or
  /// root's.
  std::function<bool(const Credentials&)> authorize{};
  std::chrono::milliseconds handshake_timeout{2000};
};

struct SubscriberStats {
  std::uint64_t received = 0;  ///< messages handed out
  std::uint64_t lost = 0;      ///< messages that the publisher sent and revoked before they were taken
  std::uint64_t bytes = 0;     ///< read from the socket
  bool connected = false;
};

/// Receives what one publisher sends. Destructible from inside its own callbacks; otherwise the destructor
/// waits for a running callback, and none runs afterwards. Messages outlive their subscriber.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  /// Connects and shakes hands, for at most handshake_timeout. Errors: nobody listens, refused, another
  /// version.
  static Expected<std::shared_ptr<Subscriber>> create(SubscriberOptions options);
  /// For select, poll and epoll: readable when read() may return something. Only without own_thread, else -1.
  virtual int fd() const = 0;
  /// The next message, or null when there is none now. Does not block. Only without own_thread.
  virtual MessagePtr read() = 0;
  virtual Credentials peer() const = 0;
  virtual SubscriberStats stats() const = 0;
};

}  // namespace channel
}  // namespace tzc
