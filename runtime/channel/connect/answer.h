// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>

#include "channel/wire/wire.h"
#include "posix/packet.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

/// What a publisher's process says to a Hello.
class Answer {
 public:
  /// Error: no answer in time, or a Refusal, with its reason.
  Status await(int socket, std::chrono::milliseconds timeout);
  /// False: it is no such packet of this version.
  template <class Packet>
  bool parse(PacketKind kind, Packet& packet) const {
    if (packet_.size != sizeof packet) return false;
    std::memcpy(&packet, memory_.data(), sizeof packet);
    return packet.kind == kind && packet.version == wire_version;
  }
  posix::FileDescriptor take_descriptor() { return std::move(packet_.descriptors[0]); }

 private:
  std::array<std::uint8_t, 1024> memory_{};
  posix::ReceivedPacket packet_;
};

/// Every failure of a greeting begins alike.
Error subscribe_failed(const std::string& why);

}  // namespace channel
}  // namespace tzc
