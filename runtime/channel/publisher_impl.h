// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "channel/connection.h"
#include "channel/pending_peer.h"
#include "channel/service.h"
#include "posix/hot.h"
#include "posix/socket.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The listening socket and the connections of a Publisher. The service keeps it while it listens, so the
/// user may destroy the handle (publisher.cpp) at any time, also inside a callback.
class PublisherImpl final : public Watcher,
                            public PeerAdmission,
                            public ConnectionOwner,
                            public std::enable_shared_from_this<PublisherImpl> {
 public:
  static Expected<std::shared_ptr<PublisherImpl>> create(PublisherOptions options);
  PublisherImpl(PublisherOptions options, posix::Listener listener, Service& service);

  const std::string& address() const { return listener_.address(); }
  const std::shared_ptr<SegmentMemory>& memory() const { return options_.memory; }
  TZC_HOT std::size_t publish(const RecordPtr& record);
  std::vector<ConnectionPtr> connections() const;
  PublisherStats stats() const;
  /// Afterwards no callback runs, except one that calls this.
  void shutdown();

  /// A peer introduced itself (service thread).
  void admit(posix::FileDescriptor socket, Peer peer) override;
  /// A subscriber left (service thread).
  void disconnected(const std::shared_ptr<ConnectionImpl>& connection) override;
  void count_refused_peer() override { ++refused_peers_; }

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;

 private:
  Status start();
  void greet(posix::FileDescriptor socket);
  bool authorized(const Peer& peer) const;
  std::shared_ptr<ConnectionImpl> connect(posix::FileDescriptor& socket, Peer peer, Error& failure);

  PublisherOptions options_;
  posix::Listener listener_;
  Service& service_;
  std::uint64_t key_ = 0;
  std::atomic<bool> closed_{false};
  std::atomic<std::uint64_t> refused_peers_{0};
  std::atomic<std::uint64_t> accept_failures_{0};

  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<ConnectionImpl>> connections_;
  PublisherStats past_;  // of the connections that are gone, and what the publisher itself counts
};

}  // namespace channel
}  // namespace tzc
