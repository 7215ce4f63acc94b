// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "channel/connect/peer.h"
#include "channel/wait/service.h"
#include "posix/file_descriptor.h"

namespace tzc {
namespace channel {

/// Decides about peers: a publisher, or several behind one socket (entrance.h). Called on the service thread.
class PeerAdmission {
 public:
  virtual ~PeerAdmission() = default;
  /// False: it admits no process of that user, whatever it says.
  virtual bool considers(const Credentials& peer) const = 0;
  /// The peer sent Hello.
  virtual void admit(posix::FileDescriptor socket, Peer peer) = 0;
  virtual void count_refused_peer() = 0;
  virtual void count_accept_failure() = 0;
};

/// A peer that connected and has not sent Hello yet. It has a few seconds to do so.
class PendingPeer final : public Watcher, public std::enable_shared_from_this<PendingPeer> {
 public:
  static bool start(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
                    std::weak_ptr<PeerAdmission> admission);
  PendingPeer(Service& service, posix::FileDescriptor socket, const Credentials& credentials,
              std::weak_ptr<PeerAdmission> admission);
  ~PendingPeer() override;

  void on_event(const posix::Poller::Event& event) override;
  void on_deadline() override;

 private:
  void end();

  Service& service_;
  posix::FileDescriptor socket_;
  const Credentials credentials_;
  const std::weak_ptr<PeerAdmission> admission_;
  std::uint64_t key_ = 0;
};

/// Parses a Hello packet; false with the reason when it is not one of this version.
bool parse_hello(const std::uint8_t* data, std::size_t size, Peer& peer, std::string& reason);

/// Tells a peer why it is not accepted.
void refuse(int socket, const std::string& reason);

}  // namespace channel
}  // namespace tzc
