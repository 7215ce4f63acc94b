// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "channel/connect/trunk.h"
#include "posix/file_descriptor.h"
#include "tzc/credentials.h"

namespace tzc {
namespace channel {

/// The trunk that a connection wants its sockets from.
struct PeerTrunk {
  std::uint64_t id = 0;  ///< 0: the connection has none
  std::uint32_t number = 0;
  std::unique_ptr<TrunkPlace> place{};
};

/// A subscriber that sent Hello. The kernel recorded the credentials; the rest is not trusted.
struct Peer {
  Credentials credentials;
  std::string hello{};
  std::uint64_t publication = 0;  ///< which publisher behind the socket it wants
  bool takes_promptly = false;
  bool reads_ring = false;
  bool has_doorbell = false;
  std::uint32_t doorbell_bytes = 0;
  std::uint32_t doorbell_number = 0;
  posix::FileDescriptor doorbell{};
  bool is_trunk = false;
  PeerTrunk trunk{};
};

}  // namespace channel
}  // namespace tzc
