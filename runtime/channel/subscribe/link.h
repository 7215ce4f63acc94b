// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "channel/connect/lent_sockets.h"
#include "channel/connect/trunk.h"
#include "channel/subscribe/write_notice.h"
#include "channel/wait/hang_up_watch.h"
#include "channel/wait/receiver.h"
#include "channel/wire/shared_page.h"
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
  std::shared_ptr<TrunkPlace> trunk{};  ///< null: the connection keeps its socket
};

/// What this process may do with views of received blocks.
struct ViewUse {
  segment::ViewWrites writes = segment::ViewWrites::private_pages;
  /// on_message hands them over, and readies the code that gets them (SubscriberOptions::hands_over)
  bool handed_over = false;
};

/// A subscriber's open connection: the socket, or the place on a trunk, and the shared page. Every message keeps it open,
/// because the publisher reclaims everything when the socket hangs up, or the place is given up.
class Link final : public HangUpListener, public TrunkListener, public std::enable_shared_from_this<Link> {
 public:
  /// Connects and shakes hands, within options.handshake_timeout.
  static Expected<std::shared_ptr<Link>> connect(const SubscriberOptions& options, RingPlace place);
  Link(posix::FileDescriptor socket, const Credentials& peer, RingPlace place);
  ~Link() override;
  /// On a connected socket; with the publisher of that number behind it.
  Status shake_hands(const SubscriberOptions& options, std::uint64_t publication);

  LentSockets& sockets() { return sockets_; }
  const Credentials& peer() const { return peer_; }
  std::uint32_t first_sequence() const { return first_sequence_; }
  const SharedPage& page() const { return page_; }
  /// Null: everything comes through the socket.
  Ring* ring() const { return ring_; }
  /// Only records that are already sent still arrive; wakes a reader that sleeps on the ring.
  void end() override;
  void heard(TrunkWord word, posix::FileDescriptor socket) override;
  void trunk_lost() override { end(); }
  const std::atomic<bool>& ended() const { return ended_; }
  const ViewUse& view_use() const { return view_use_; }
  WriteNotice& write_notice() const { return *notice_; }
  /// Counts destroyed messages that this process had written to.
  std::atomic<std::uint64_t>& written() const { return written_; }
  /// True in a forked child, which must not send for its parent.
  bool forked() const;
  /// Unsubscribes; the connection stays open. A reader blocked on it returns.
  void unsubscribe();

 private:
  Status say_hello(const SubscriberOptions& options, std::uint64_t publication) const;
  Status await_welcome(std::chrono::milliseconds timeout);
  Status use_ring(std::uint32_t features);
  void look_again();

  LentSockets sockets_;
  const Credentials peer_;
  const std::uint32_t epoch_;
  RingPlace place_;
  SharedPage page_;
  Ring* ring_ = nullptr;
  std::atomic<bool> ended_{false};
  ViewUse view_use_;
  std::shared_ptr<WriteNotice> notice_;
  mutable std::atomic<std::uint64_t> written_{0};
  std::shared_ptr<HangUpWatch> watch_;
  std::uint32_t first_sequence_ = 0;
};

}  // namespace channel
}  // namespace tzc
