// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "channel/connect/accepted_trunks.h"
#include "channel/connect/pending_peer.h"
#include "channel/wait/service.h"
#include "posix/file_descriptor.h"
#include "posix/socket.h"

namespace tzc {
namespace channel {

/// A listening socket, and the publishers that are reached through it:
///
///   connect --> a user of whom a publisher may admit processes? --> Hello --> the publisher that it names decides
///
/// A process whose Hello says so gets a trunk instead, which it names when it comes to a publisher here.
/// All publishers of this process that listen at no address of their own share one. It listens until its last owner, a
/// publisher, is gone. Thread-safe; calls publishers on the service thread and without a lock.
class Entrance final : public PeerAdmission, public std::enable_shared_from_this<Entrance> {
 public:
  /// The one of this process, at an address that cannot be guessed; in a forked child its own.
  static Expected<std::shared_ptr<Entrance>> of_process();
  /// For one publisher.
  static Expected<std::shared_ptr<Entrance>> at(const std::string& address);
  Entrance(posix::Listener listener, Service& service, bool numbered);
  ~Entrance() override;
  Entrance(const Entrance&) = delete;
  Entrance& operator=(const Entrance&) = delete;

  /// Returns its number here, which cannot be guessed; 0 where it is the only one.
  std::uint64_t enter(std::weak_ptr<PeerAdmission> publisher);
  /// No peer comes to it from now on; a call to it may still be running.
  void leave(std::uint64_t number);
  /// The text with which that publisher is reached.
  std::string address_of(std::uint64_t number) const;

  void accept_some();
  void resume();

  bool considers(const Credentials& peer) const override;
  void admit(posix::FileDescriptor socket, Peer peer) override;
  /// \name They did not come to say which publisher they want, so each of them counts
  /// @{
  void count_refused_peer() override;
  void count_accept_failure() override;
  /// @}

 private:
  static Expected<std::shared_ptr<Entrance>> open(const std::string& address, bool numbered);
  Status start();
  void greet(posix::FileDescriptor socket);
  std::vector<std::shared_ptr<PeerAdmission>> publishers() const;
  std::shared_ptr<PeerAdmission> find(std::uint64_t number) const;

  const posix::Listener listener_;
  Service& service_;
  const bool numbered_;
  const std::uint32_t epoch_;
  std::uint64_t key_ = 0;

  mutable std::mutex mutex_;
  std::map<std::uint64_t, std::weak_ptr<PeerAdmission>> publishers_;
  AcceptedTrunks trunks_;
};

}  // namespace channel
}  // namespace tzc
