// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "channel/announced_segments.h"
#include "channel/outbox.h"
#include "channel/service.h"
#include "channel/shared_page.h"
#include "channel/undecided.h"
#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

class Hub;

/// A subscriber seen from its publisher.
///
///   corked --uncork--> open --close, or the subscriber unsubscribes--> draining --hang-up--> gone
///
/// Draining: nothing is sent any more, but the subscriber may still hold blocks; they stay its own until its
/// socket hangs up. Owned by the service while its socket is open.
class ConnectionImpl final : public Connection,
                             public Watcher,
                             public segment::Revoker,
                             public std::enable_shared_from_this<ConnectionImpl> {
 public:
  struct Peer {
    Credentials credentials;
    std::string hello;
    bool reads_ring = false;
  };

  ConnectionImpl(posix::FileDescriptor socket, Peer peer, SharedPage page, std::size_t queue_size,
                 std::weak_ptr<Hub> hub, bool keeps_undelivered);

  Credentials peer() const override { return peer_.credentials; }
  const std::string& hello() const override { return peer_.hello; }
  bool alive() const override;
  TZC_HOT bool send(const RecordPtr& record) override;
  Error last_failure() const override;
  void close() override;
  ConnectionStats stats() const override;
  std::size_t untaken() override;
  std::vector<RecordPtr> take_undelivered() override;

  /// Hands the socket to the service; until uncork() records only queue.
  Status start(Service& service);
  /// Tells the subscriber that it is accepted, then sends what was queued.
  void uncork();

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;
  void give_up(const segment::BlockName& block) override;

 private:
  enum class State { corked, open, draining, gone };

  bool accepts_records() const { return state_ == State::corked || state_ == State::open; }
  TZC_HOT bool announce_segments(const Record& record);
  bool is_announced(const Buffer& buffer) const;
  bool announce_missing_segments(const Record& record);
  Status announce(segment::Segment& segment);
  void retire_segments();
  TZC_HOT void claim(const RecordPtr& record);
  TZC_HOT static void keep(const RecordPtr& record, Undecided::Entry& entry);
  bool writes_directly() const { return state_ == State::open && outbox_.empty(); }
  TZC_HOT void transmit(const RecordPtr& record);
  TZC_HOT bool write_into_ring(const Record& record);
  void transmit(Outgoing item);
  TZC_HOT bool is_done(posix::SendResult written);
  void wait_in_line(Outgoing item);
  void flush();
  void try_again(posix::SendResult result);
  void watch_writable(bool wanted);
  void settle();
  void revoke_through(std::uint32_t sequence);
  void end_deliveries();
  bool recall(const Undecided::Entry& entry);
  void revoke_oldest_down_to(std::size_t most);
  void revoke_mark(const segment::BlockName& block);
  void drop_oldest_undecided(bool revoked);
  void end_stream();
  void peer_stopped();
  void give_up_on_peer();
  void break_off();
  void unsubscribed();
  void hung_up();

  const Peer peer_;
  const std::size_t queue_size_;
  const std::weak_ptr<Hub> hub_;
  const std::uint32_t epoch_;
  const bool keeps_undelivered_;
  Service* service_ = nullptr;
  std::uint64_t key_ = 0;

  mutable std::mutex mutex_;
  State state_ = State::corked;
  bool closing_ = false;
  Service::Clock::time_point linger_ends_;
  bool writable_watched_ = false;
  posix::FileDescriptor socket_;
  SharedPage page_;
  RingWriter ring_;
  std::uint32_t last_sequence_;
  Undecided undecided_;
  std::vector<RecordPtr> undelivered_;
  Outbox outbox_;
  Traffic traffic_;
  AnnouncedSegments segments_;
  ConnectionStats stats_;
  Error failure_;
};

/// Sequence numbers start shortly before they wrap around, so that every run exercises it.
constexpr std::uint32_t first_sequence = 0xffffffff - 5;

}  // namespace channel
}  // namespace tzc
