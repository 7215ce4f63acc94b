// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "channel/hang_up_watch.h"
#include "channel/receiver.h"
#include "channel/shared_page.h"
#include "channel/write_notice.h"
#include "posix/file_descriptor.h"
#include "segment/received_segment.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// What a subscriber needs so that records may come through the ring: a service, which watches for the publisher's end, and
/// a thread of its own or a number of the doorbell where the shared one sleeps. No service: all come through the socket.
struct RingPlace {
  Service* service = nullptr;
  std::shared_ptr<DoorbellNumber> number{};
};

/// A subscriber's open connection: the socket and the shared page. Every message keeps it open, because the
/// publisher reclaims everything when the socket hangs up.
class Link final : public HangUpListener {
 public:
  /// Connects and shakes hands, within options.handshake_timeout.
  static Expected<std::shared_ptr<Link>> connect(const SubscriberOptions& options, RingPlace place);
  Link(posix::FileDescriptor socket, const Credentials& peer, RingPlace place);
  ~Link() override;
  /// On a connected socket; with the publisher of that number behind it.
  Status shake_hands(const SubscriberOptions& options, std::uint64_t publication);

  int fd() const { return socket_.get(); }
  const Credentials& peer() const { return peer_; }
  std::uint32_t first_sequence() const { return first_sequence_; }
  const SharedPage& page() const { return page_; }
  /// Null: everything comes through the socket.
  Ring* ring() const { return ring_; }
  /// Only records that are already sent still arrive; wakes a reader that sleeps on the ring.
  void end() override;
  const std::atomic<bool>& ended() const { return ended_; }
  segment::ViewWrites writes() const { return writes_; }
  segment::WriteListener* write_listener() const { return notice_.get(); }
  WriteNotice& write_notice() const { return *notice_; }
  /// Counts a destroyed message that this process had written to.
  void count_written() const { written_.fetch_add(1, std::memory_order_relaxed); }
  std::uint64_t written() const { return written_.load(std::memory_order_relaxed); }
  /// True in a forked child, which must not send for its parent.
  bool forked() const;
  /// Unsubscribes; the socket stays open. A reader blocked on it returns.
  void unsubscribe();

 private:
  Status say_hello(const SubscriberOptions& options, std::uint64_t publication) const;
  Status await_welcome(const SubscriberOptions& options);
  Status use_ring();
  Status accept_welcome(const std::uint8_t* data, std::size_t size, posix::FileDescriptor page);

  posix::FileDescriptor socket_;
  const Credentials peer_;
  const std::uint32_t epoch_;
  const RingPlace place_;
  SharedPage page_;
  Ring* ring_ = nullptr;
  std::atomic<bool> ended_{false};
  segment::ViewWrites writes_ = segment::ViewWrites::private_pages;
  std::shared_ptr<WriteNotice> notice_;
  mutable std::atomic<std::uint64_t> written_{0};
  std::shared_ptr<HangUpWatch> watch_;
  std::uint32_t first_sequence_ = 0;
};

}  // namespace channel
}  // namespace tzc
