// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "channel/outbox.h"
#include "channel/ring.h"
#include "channel/service.h"
#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "posix/packet.h"

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
  PacketSender(posix::FileDescriptor socket, RingWriter ring, std::size_t most_waiting);
  /// The service watches the socket from now on, under that key.
  void watched_by(Service& service, std::uint64_t key);
  int socket() const { return socket_.get(); }

  TZC_HOT Result send(const RecordPtr& record, std::uint32_t sequence);
  Result send(Outgoing item);
  Result uncork();
  /// Writes from the outbox as much as the socket takes; ends the stream after the last packet if end() was
  /// called.
  Result flush();
  /// Sends the outbox until the deadline at most, then ends the stream.
  Result end_by(Service::Clock::time_point deadline);
  void end_stream();
  void drop_records_through(std::uint32_t sequence);
  void drop_all() { outbox_.clear(); }
  /// The subscriber sends nothing more: watch only for its hang-up.
  void stop_reading();
  /// Stops watching and closes the socket.
  void close();

  std::uint64_t bytes() const { return traffic_.bytes; }
  std::size_t waiting_records() const { return outbox_.records(); }

 private:
  TZC_HOT bool write_into_ring(const Record& record, std::uint32_t sequence);
  TZC_HOT bool is_done(posix::SendResult written, Result& result);
  Result enqueue(Outgoing item);
  void try_again(posix::SendResult result);

  posix::FileDescriptor socket_;
  RingWriter ring_;
  const std::size_t most_waiting_;
  Service* service_ = nullptr;
  std::uint64_t key_ = 0;
  bool corked_ = true;
  bool writable_watched_ = false;
  bool ending_ = false;
  Service::Clock::time_point deadline_{};
  Outbox outbox_;
  Traffic traffic_;
};

}  // namespace channel
}  // namespace tzc
