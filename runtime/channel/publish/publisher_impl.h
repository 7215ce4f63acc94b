// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "channel/connect/entrance.h"
#include "channel/connect/pending_peer.h"
#include "channel/publish/connection.h"
#include "channel/wait/service.h"
#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The connections of a Publisher, and its place behind an entrance. Who calls it keeps it, so the user may destroy the
/// handle (publisher.cpp) at any time, also inside a callback.
class PublisherImpl final : public PeerAdmission,
                            public ConnectionOwner,
                            public std::enable_shared_from_this<PublisherImpl> {
 public:
  static Expected<std::shared_ptr<PublisherImpl>> create(PublisherOptions options);
  PublisherImpl(PublisherOptions options, std::shared_ptr<Entrance> entrance, Service& service);

  const std::string& address() const { return address_; }
  const std::shared_ptr<SegmentMemory>& memory() const { return options_.memory; }
  TZC_HOT std::size_t publish(const RecordPtr& record);
  std::vector<ConnectionPtr> connections() const;
  PublisherStats stats() const;
  /// Afterwards no callback runs, except one that calls this.
  void shutdown();

  bool considers(const Credentials& peer) const override;
  void admit(posix::FileDescriptor socket, Peer peer) override;
  /// A subscriber left (service thread).
  void disconnected(const std::shared_ptr<ConnectionImpl>& connection) override;
  void count_refused_peer() override { ++refused_peers_; }
  void count_accept_failure() override { ++accept_failures_; }

 private:
  void enter();
  bool authorized(const Peer& peer) const;
  std::shared_ptr<ConnectionImpl> connect(posix::FileDescriptor& socket, Peer peer, Error& failure);

  PublisherOptions options_;
  std::shared_ptr<Entrance> entrance_;  // until shutdown
  Service& service_;
  std::uint64_t number_ = 0;  // behind the entrance
  std::string address_;
  std::atomic<bool> closed_{false};
  std::atomic<std::uint64_t> refused_peers_{0};
  std::atomic<std::uint64_t> accept_failures_{0};

  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<ConnectionImpl>> connections_;
  PublisherStats past_;  // of the connections that are gone, and what the publisher itself counts
};

}  // namespace channel
}  // namespace tzc
