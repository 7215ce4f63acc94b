// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "channel/peer.h"
#include "channel/trunk.h"

namespace tzc {
namespace channel {

/// The trunks that subscribers' processes opened to this one. Thread-safe.
class AcceptedTrunks {
 public:
  /// Makes the socket a trunk, and says so to the peer, or why not.
  void accept(Service& service, posix::FileDescriptor socket, const Credentials& peer);
  /// Gives the peer the place that it named. False: that trunk, or that number, is not the peer's.
  bool place(Peer& peer);

 private:
  void keep(const std::shared_ptr<Trunk>& trunk);
  std::shared_ptr<Trunk> find(std::uint64_t id);

  std::mutex mutex_;
  std::map<std::uint64_t, std::weak_ptr<Trunk>> trunks_;
};

}  // namespace channel
}  // namespace tzc
