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

/// Copies the control part and seals the buffers. `tag` is for the application; the channel passes it through
/// unchanged. A control part that fits no slot of the connections' rings (some 400 bytes) goes into a block of `memory` when that
/// is given and not exhausted, otherwise over the socket, which takes half as long again, and longer the larger it is. Give it a
/// memory of its own: small blocks between large ones waste room. Null when a buffer is null or, in a forked child, its parent's
/// (Buffer::inherited), or when can_carry() gives an error.
RecordPtr make_record(std::uint32_t tag, const void* control, std::size_t control_size,
                      BufferSpan buffers = {}, MemorySource* memory = nullptr);

/// Whether a record can hold so many bytes of control part and so many buffers (at most 4096). Error: what is
/// too large, and what to do about it.
Status can_carry(std::size_t control_size, std::size_t buffer_count);

/// The content of a record. Valid while the record lives.
struct RecordParts {
  std::uint32_t tag;
  const std::uint8_t* control;
  std::size_t control_size;
  std::vector<ConstBlock> blocks;
};
RecordParts parts_of(const Record& record);

/// Counters of one subscriber, seen from the publisher. A record counts as dropped when it was revoked: the
/// queue was full, the memory was needed (best_effort), or the subscriber left.
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
  /// The text with which the subscriber introduced itself (SubscriberOptions::hello). Not trusted.
  virtual const std::string& hello() const = 0;
  /// False after the subscriber unsubscribed or died, or after close().
  virtual bool alive() const = 0;
  /// Never blocks: writes directly, or queues when the socket is full. At most queue_size records (see also
  /// buffered_bytes) are in flight; beyond that the oldest is revoked and counted. False when the connection is not alive, or when
  /// the record's memory cannot be shared with this subscriber (alive() stays true, last_failure() says why:
  /// send the message without shared memory instead), as that of a record which was made before this process was forked.
  virtual bool send(const RecordPtr& record) = 0;
  virtual Error last_failure() const = 0;
  /// Ends the subscription. Records already sent still arrive; blocks that the subscriber holds stay valid.
  virtual void close() = 0;
  virtual ConnectionStats stats() const = 0;
  /// Records that are sent and not taken by the subscriber yet.
  virtual std::size_t in_flight() = 0;
  /// Blocks that the subscriber has taken and not released, by its own word. Slow: looks at every block that it was sent.
  virtual std::size_t held() const = 0;
  /// With PublisherOptions::keeps_undelivered, after the connection ended: the records in flight at that
  /// time, oldest first. The subscriber never takes them. Returns each of them once.
  virtual std::vector<RecordPtr> take_undelivered() = 0;
};
using ConnectionPtr = std::shared_ptr<Connection>;

/// How a publisher is reached, and what it does about each subscriber; fixed when it is created.
struct PublisherOptions {
  /// Empty: an abstract name with a 128-bit nonce (a pathname in the portable build), whose socket all such publishers
  /// of the process share. "@name": that abstract name. Otherwise a pathname, at most 107 bytes; replaces a leftover
  /// socket file that no process listens on. Neither contains '#'.
  std::string address{};
  /// Most records that may be in flight for each subscriber; 0: as many as the protocol can count (65535).
  std::size_t queue_size = 10;
  /// Over 0: to a subscriber with SubscriberOptions::shared_thread one more record, and before it as many as have this many
  /// bytes together (with their blocks, and 256 bytes for each). So a burst arrives as over a TCP connection, whose sockets
  /// hold what the queue does not. When memory is exhausted, what is in flight beyond queue_size is revoked, whatever its
  /// policy. Other subscribers may run callbacks between two messages: for them the newest queue_size are kept.
  std::size_t buffered_bytes = 0;
  /// Several publishers may share it. Null: the publisher creates its own, with default options for this
  /// queue size.
  std::shared_ptr<SegmentMemory> memory{};
  /// Keeps the records that are in flight when a connection ends, for Connection::take_undelivered().
  bool keeps_undelivered = false;
  /// Decides on the service thread whether a subscriber may connect. Null: only processes of the same user
  /// may.
  std::function<bool(const Credentials&, const std::string& hello)> authorize{};
  /// Called on the service thread, before the subscriber learns that it is accepted; records sent here arrive
  /// first. authorize and on_connect must return quickly: one thread, with 1 MB of stack, serves all publishers of the process.
  std::function<void(const ConnectionPtr&)> on_connect{};
  /// Called once for each connection that on_connect saw, when the subscriber unsubscribed or died.
  std::function<void(const ConnectionPtr&)> on_disconnect{};
  /// Called on the service thread for a subscriber that was authorized and cannot be connected, because this process lacks
  /// descriptors or memory. It may try again.
  std::function<void(const std::string& hello, const Error&)> on_failure{};
};

/// What a publisher has done since it was created: a snapshot.
struct PublisherStats {
  std::uint64_t published = 0;    ///< publish() calls
  std::uint64_t not_records = 0;  ///< of those, calls with a null record: sent to no subscriber
  std::uint64_t sent = 0;         ///< records accepted for some subscriber, summed
  std::uint64_t dropped = 0;      ///< records revoked before their subscriber took them, summed
  /// Not authorized, or not speaking this protocol. One that did not say which publisher it wants counts for each that
  /// shares the socket, here and below.
  std::uint64_t refused_peers = 0;
  std::uint64_t accept_failures = 0;  ///< connections that failed here, e.g. too many open files
  std::size_t subscribers = 0;        ///< connections alive now
};

/// Listens for subscribers and sends them records. Thread-safe. Destroying the last shared_ptr waits for a
/// running callback (unless a callback does it): hold no lock then that a callback takes. No callback runs
/// afterwards; for up to a second the service still sends what is queued for live subscribers.
class Publisher {
 public:
  virtual ~Publisher() = default;
  /// Errors: the address is taken, too long or contains '#', no descriptors left.
  static Expected<std::shared_ptr<Publisher>> create(PublisherOptions options);
  /// The address for SubscriberOptions::address.
  virtual const std::string& address() const = 0;
  virtual const std::shared_ptr<SegmentMemory>& memory() const = 0;
  /// Sends to every live subscriber. Returns how many accepted the record. Never blocks.
  virtual std::size_t publish(const RecordPtr& record) = 0;
  virtual std::vector<ConnectionPtr> connections() const = 0;
  virtual PublisherStats stats() const = 0;
};

/// A received record. Immutable. Until it is destroyed this process holds its blocks (the publisher cannot
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

/// Where a subscriber connects to and who is told what; fixed when it is created.
struct SubscriberOptions {
  std::string address{};  ///< as Publisher::address()
  std::string hello{};    ///< passed to the publisher's authorize and on_connect; at most 32 KB
  /// True: the subscriber starts a thread that reads and calls on_message. False: the caller waits on fd()
  /// and calls read().
  bool own_thread = true;
  /// With own_thread: no thread for this subscriber alone, but the one that reads for all such subscribers of this
  /// process. on_message must then return quickly and wait for nothing: meanwhile no other of them gets a message. Where
  /// the system has no futex that processes share (portable build), and for more than 4096 such subscribers, a thread is
  /// started as without it.
  bool shared_thread = false;
  /// With shared_thread: asked on that thread when the first message has come, and again every millisecond until it
  /// returns true. Messages wait meanwhile. Null: true. Never asked where a thread is started.
  std::function<bool()> may_begin{};
  std::function<void(const MessagePtr&)> on_message{};
  /// Called once when the publisher left or broke the protocol; `reason` is a text for people.
  std::function<void(const std::string& reason)> on_disconnect{};
  /// Decides whether to connect to the publisher, before anything is sent to it. Null: only a publisher of
  /// the same user or of root.
  std::function<bool(const Credentials&)> authorize{};
  std::chrono::milliseconds handshake_timeout{2000};
  /// A write to a block of a received message (through a cast: blocks are const) changes bytes that this message alone
  /// has: a block below a page is copied when it is received, one of a page or more gets pages of its own at the first
  /// write. Not by system calls: `read` into such a block fails with EFAULT. Installs a handler of SIGSEGV. Where the
  /// system refuses what that needs, all blocks are copied (SubscriberStats::copies_blocks). False: no block is copied
  /// for this, and such a write is a SIGSEGV.
  bool private_writes = true;
  /// With private_writes, for TZC's own transports, which let messages wait for the code that may write to them: true: the
  /// transport sees to it, before that code sees the message, that the handler of SIGSEGV is the first one and that the
  /// thread does not block that signal (channel/fault_signals.h). False: the subscriber sees to both, with two system
  /// calls, before on_message is called or read() returns.
  bool hands_over = false;
  /// Called once, soon after code of this process has first written to a block of a page or more: by the service thread,
  /// or by the subscriber's own. Only with own_thread.
  std::function<void()> on_write{};
};

/// What a subscriber has received since it was created: a snapshot.
struct SubscriberStats {
  std::uint64_t received = 0;  ///< messages returned by read() or passed to on_message
  std::uint64_t lost = 0;      ///< messages that the publisher sent and revoked before they were taken
  std::uint64_t bytes = 0;     ///< read from the socket
  std::uint64_t written = 0;   ///< blocks of destroyed messages that this process wrote to
  bool copies_blocks = false;  ///< private_writes is on, and the system refuses what it needs
  bool connected = false;
};

/// Receives what one publisher sends. Destructible from inside its own callbacks; otherwise the destructor
/// waits for a running callback, and none runs afterwards. Messages outlive their subscriber.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  /// Connects and shakes hands, for at most handshake_timeout. Errors: no process listens, the publisher
  /// refused, another version.
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
