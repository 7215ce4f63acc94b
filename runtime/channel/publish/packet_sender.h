// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "channel/connect/sending_socket.h"
#include "channel/publish/outbox.h"
#include "channel/wait/service.h"
#include "channel/wire/ring.h"
#include "posix/hot.h"
#include "posix/packet.h"
#include "segment/block.h"

namespace tzc {
namespace channel {

/// Writes packets to one subscriber, in order: a usual record into the ring, everything else into the socket.
/// What does not fit waits in the outbox until the service reports that the socket takes more. Not
/// thread-safe.
class PacketSender {
 public:
  enum class Result {
    accepted,  ///< written, or in the outbox
    gone,      ///< the subscriber is no longer there
    too_slow,  ///< the outbox has more than a running subscriber can leave there: it stopped
  };

  /// Corked: until uncork() everything waits. `most_waiting`: packets in the outbox.
  PacketSender(SendingSocket socket, RingWriter ring, std::size_t most_waiting);
  SendingSocket& socket() { return socket_; }
  const SendingSocket& socket() const { return socket_; }

  TZC_HOT Result send(const RecordPtr& record, std::uint32_t sequence);
  Result send(Outgoing item);
  Result uncork();
  /// Writes from the outbox as much as the socket takes; ends the stream after the last packet if end() was
  /// called.
  Result flush();
  /// Sends the outbox until the deadline at most, then ends the stream.
  Result end_by(Service::Clock::time_point deadline);
  void end_stream();
  /// Gives a loan up that was not needed for some time, or that others wait for, or looks again later: ever later while the
  /// subscriber reads nothing.
  void rest();
  void drop_records_through(std::uint32_t sequence);
  void drop_all() { outbox_.clear(); }

  std::uint64_t bytes() const { return traffic_.bytes; }
  std::size_t waiting_records() const { return outbox_.records(); }
  void add_waiting(const segment::BlockName& block, std::vector<const void*>& handles) const {
    outbox_.add_handles(block, handles);
  }

 private:
  TZC_HOT bool write_into_ring(const Record& record, std::uint32_t sequence);
  TZC_HOT bool is_done(posix::SendResult written, Result& result);
  Result enqueue(Outgoing item);
  void try_again(posix::SendResult result);
  template <class Write>
  TZC_HOT posix::SendResult through_socket(Write write);

  SendingSocket socket_;
  RingWriter ring_;
  const std::size_t most_waiting_;
  bool corked_ = true;
  bool ending_ = false;
  Service::Clock::time_point deadline_{};
  Outbox outbox_;
  Traffic traffic_;
  std::uint32_t packets_at_rest_ = 0;
  std::chrono::milliseconds patience_{1};
};

}  // namespace channel
}  // namespace tzc
