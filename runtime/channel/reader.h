// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "channel/link.h"
#include "channel/received_message.h"
#include "posix/packet.h"
#include "segment/received_segment.h"

namespace tzc {
namespace channel {

/// Counters that another thread may read.
struct ReaderCounters {
  std::atomic<std::uint64_t> received{0};
  std::atomic<std::uint64_t> lost{0};
  std::atomic<std::uint64_t> bytes{0};
};

/// Turns what arrives on a link into messages. Trusts nothing: a packet that breaks the protocol ends the
/// connection, with the reason. Used by one thread at a time.
class Reader {
 public:
  enum class Result { message, nothing, closed };

  explicit Reader(std::shared_ptr<const Link> link);

  /// The next message. `nothing`: none there now (return_at_once only). `closed`: see reason().
  Result read(posix::Waiting waiting, MessagePtr& message);
  const std::string& reason() const { return reason_; }
  const ReaderCounters& counters() const { return counters_; }

 private:
  struct Assembly {
    std::uint32_t sequence = 0;
    std::uint64_t total = 0;
    std::vector<std::uint8_t> bytes;
  };

  bool handle(posix::ReceivedPacket& packet, MessagePtr& message);
  bool open_segment(posix::ReceivedPacket& packet);
  bool retire_segment(const posix::ReceivedPacket& packet);
  bool accept_record(const posix::ReceivedPacket& packet, MessagePtr& message);
  bool accept_fragment(const posix::ReceivedPacket& packet, MessagePtr& message);
  bool deliver(std::uint32_t sequence, std::vector<std::uint8_t> body, MessagePtr& message);
  bool advance(std::uint32_t sequence);
  bool take(const ParsedBody& parsed, std::vector<ReceivedMessage::Hold>& holds);
  bool broken(const std::string& why);

  const std::shared_ptr<const Link> link_;
  std::vector<std::uint8_t> memory_;
  std::map<std::uint64_t, std::shared_ptr<segment::ReceivedSegment>> segments_;
  Assembly assembly_;
  std::uint32_t last_sequence_;
  ReaderCounters counters_;
  std::string reason_;
};

}  // namespace channel
}  // namespace tzc
