// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "channel/connection.h"
#include "channel/service.h"
#include "posix/hot.h"
#include "posix/socket.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// What a Publisher is made of: the listening socket and the connections. The service keeps it while it
/// listens, so the user's handle (publisher.cpp) can go at any time, also inside a callback.
class Hub final : public Watcher, public std::enable_shared_from_this<Hub> {
 public:
  static Expected<std::shared_ptr<Hub>> create(PublisherOptions options);
  Hub(PublisherOptions options, posix::Listener listener, Service& service);

  const std::string& address() const { return listener_.address(); }
  const std::shared_ptr<SegmentMemory>& memory() const { return options_.memory; }
  TZC_HOT std::size_t publish(const RecordPtr& record);
  std::vector<ConnectionPtr> connections() const;
  PublisherStats stats() const;
  /// Afterwards no callback runs any more, except the one that is calling this.
  void shutdown();

  /// A peer introduced itself (service thread).
  void admit(posix::FileDescriptor socket, ConnectionImpl::Peer peer);
  /// A subscriber left (service thread).
  void disconnected(const std::shared_ptr<ConnectionImpl>& connection);
  void count_refused_peer() { ++refused_peers_; }

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;

 private:
  Status start();
  void greet(posix::FileDescriptor socket);
  bool authorized(const ConnectionImpl::Peer& peer) const;
  std::shared_ptr<ConnectionImpl> connect(posix::FileDescriptor& socket, ConnectionImpl::Peer peer,
                                          Error& failure);

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

/// Tells a peer why it is not accepted.
void refuse(int socket, const std::string& reason);

}  // namespace channel
}  // namespace tzc
