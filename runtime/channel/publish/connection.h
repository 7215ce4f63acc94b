// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "channel/connect/peer.h"
#include "channel/connect/trunk.h"
#include "channel/inspection.h"
#include "channel/publish/announced_segments.h"
#include "channel/publish/in_flight_window.h"
#include "channel/publish/packet_sender.h"
#include "channel/wait/service.h"
#include "channel/wire/shared_page.h"
#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "segment/segment.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

class ConnectionImpl;

/// The lifecycle of a connection; see ConnectionImpl.
enum class ConnectionState { corked, open, draining, gone };

/// Called on the service thread when a subscriber leaves: once when it unsubscribes, once more when it hangs
/// up.
class ConnectionOwner {
 public:
  virtual ~ConnectionOwner() = default;
  virtual void disconnected(const std::shared_ptr<ConnectionImpl>& connection) = 0;
};

/// The publisher's side of one subscriber: its lifecycle. InFlightWindow has what is in flight to it,
/// PacketSender writes to it.
///
///   corked --uncork--> open --close, or the subscriber unsubscribes--> draining --hang-up--> gone
///
/// Draining: nothing is sent any more, but the subscriber may still hold blocks; they are kept until its socket
/// hangs up. Owned by the service until then.
class ConnectionImpl final : public Connection,
                             public Watcher,
                             public TrunkListener,
                             public segment::Revoker,
                             public std::enable_shared_from_this<ConnectionImpl> {
 public:
  struct Options {
    InFlightLimit limit;
    bool keeps_undelivered;
    BellPull bell;          // at which the subscriber's reader is called
    const char* traced_as;  ///< lives as long as the process
  };

  ConnectionImpl(posix::FileDescriptor socket, Peer peer, SharedPage page, Options options,
                 std::weak_ptr<ConnectionOwner> owner);

  Credentials peer() const override { return subscriber_.credentials; }
  const std::string& hello() const override { return subscriber_.hello; }
  bool alive() const override;
  TZC_HOT bool send(const RecordPtr& record) override;
  Error last_failure() const override;
  void close() override;
  ConnectionStats stats() const override;
  std::size_t in_flight() override;
  std::size_t held() const override;
  std::vector<RecordPtr> take_undelivered() override;

  ConnectionInspection inspect() const;

  /// Gives the socket to the service; until uncork() records only queue.
  Status start(Service& service);
  /// Sends Welcome to the subscriber, then what was queued.
  void uncork();

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;
  void heard(TrunkWord word, posix::FileDescriptor socket) override;
  void trunk_lost() override { hung_up(); }
  void revoke(const segment::BlockName& block) override;
  void revoke_buffered() override;
  void add_waiting(const segment::BlockName& block, std::vector<const void*>& handles) const override;

 private:
  std::uint32_t granted_features() const;
  std::vector<HeldBlock> held_blocks() const;
  bool send_traced(const RecordPtr& record);
  /// Under mutex_.
  TZC_HOT bool send_now(const RecordPtr& record);
  void heed(PacketSender::Result result);
  void heed_revocation(bool honest);
  void stop_deliveries();
  void abort();
  void loan_closed();
  void unsubscribed();
  void read_unsubscribe();
  void hung_up();

  /// What stays of the peer.
  struct Subscriber {
    Credentials credentials;
    std::string hello;
    bool reads_ring;
  };
  const Subscriber subscriber_;
  const char* const traced_as_;
  const std::weak_ptr<ConnectionOwner> owner_;
  const std::uint32_t epoch_;

  mutable std::mutex mutex_;
  ConnectionState state_ = ConnectionState::corked;
  std::uint64_t sent_ = 0;
  std::unique_ptr<Error> failure_;  // of the last announcement that failed, which is rare
  SharedPage page_;
  AnnouncedSegments segments_;
  InFlightWindow window_;
  PacketSender sender_;
};

}  // namespace channel
}  // namespace tzc
