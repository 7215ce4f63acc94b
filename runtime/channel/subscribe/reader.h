// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "channel/latency_histogram.h"
#include "channel/subscribe/link.h"
#include "channel/subscribe/received_message.h"
#include "channel/subscribe/take_trace.h"
#include "channel/wire/ring.h"
#include "posix/hot.h"
#include "posix/packet.h"
#include "segment/received_segment.h"

namespace tzc {
namespace channel {

/// Counters that another thread may read.
struct ReaderCounters {
  std::atomic<std::uint64_t> received{0};
  std::atomic<std::uint64_t> lost{0};
  std::atomic<std::uint64_t> bytes{0};
  std::atomic<std::uint64_t> shared_bytes{0};
  LatencyHistogram latencies;
};

/// Turns the packets of a link into messages. Trusts none of them: one that breaks the protocol ends the
/// connection, with the reason. Used by one thread at a time.
class Reader {
 public:
  enum class Result { message, nothing, closed };

  Reader(std::shared_ptr<Link> link, const SubscriberOptions& options);

  /// The next message. `nothing`: none there now (return_at_once only). `closed`: see reason().
  TZC_HOT Result read(posix::Waiting waiting, MessagePtr& message);
  /// Whether read() has something to look at now.
  bool has_something();
  const std::string& reason() const { return reason_; }
  /// There is no further message.
  void give_up(std::string reason) { reason_ = std::move(reason); }
  const ReaderCounters& counters() const { return counters_; }
  const TakeTrace& trace() const { return trace_; }

 private:
  struct Assembly {
    std::uint32_t sequence = 0;
    std::uint64_t total = 0;
    std::vector<std::uint8_t> bytes;
  };

  TZC_HOT posix::ReceiveResult receive(posix::Waiting waiting, posix::ReceivedPacket& packet);
  TZC_HOT posix::ReceiveResult receive_from_socket(posix::Waiting waiting, posix::ReceivedPacket& packet);
  TZC_HOT bool handle(posix::ReceivedPacket& packet, MessagePtr& message);
  bool open_segment(posix::ReceivedPacket& packet);
  bool retire_segment(const posix::ReceivedPacket& packet);
  TZC_HOT bool accept_record(const posix::ReceivedPacket& packet, MessagePtr& message);
  bool accept_fragment(const posix::ReceivedPacket& packet, MessagePtr& message);
  TZC_HOT bool deliver(std::uint32_t sequence, const std::uint8_t* body, std::size_t size,
                       MessagePtr& message);
  TZC_HOT bool advance(std::uint32_t sequence);
  TZC_HOT bool take_blocks(const ParsedBody& parsed, bool& complete);
  TZC_HOT const std::shared_ptr<segment::ReceivedSegment>* find_segment(std::uint64_t id) const;
  template <class Packet>
  bool parse(std::size_t size, Packet& packet) const;
  void append_packet(std::size_t from, std::size_t size, std::vector<std::uint8_t>& bytes) const;
  bool broken(const std::string& why);

  const std::shared_ptr<Link> link_;
  RingReader ring_;
  std::shared_ptr<ReceivedMessage> next_;  // receives a packet's first bytes; overflow() the others
  std::vector<std::shared_ptr<segment::ReceivedSegment>> segments_;
  Assembly assembly_;
  std::uint32_t last_sequence_;
  ReaderCounters counters_;
  TakeTrace trace_;
  std::string reason_;
};

}  // namespace channel
}  // namespace tzc
