// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "channel/connect/peer.h"
#include "channel/connect/trunk.h"
#include "channel/wait/weak_map.h"

namespace tzc {
namespace channel {

/// The trunks that subscribers' processes opened to this one. Thread-safe.
class AcceptedTrunks {
 public:
  /// Makes the socket a trunk, and says so to the peer, or why not.
  void accept(Service& service, posix::FileDescriptor socket, const Peer& peer);
  /// Gives the peer the place that it named. False: that trunk, or that number, is not the peer's.
  bool place(Peer& peer);

 private:
  /// No publisher has agreed yet to talk to a process whose trunks have no connection, so it may not have many.
  bool has_room_for(const Credentials& peer);
  std::shared_ptr<Trunk> find(std::uint64_t id);

  std::mutex mutex_;
  WeakMap<std::uint64_t, Trunk> trunks_;
};

}  // namespace channel
}  // namespace tzc
