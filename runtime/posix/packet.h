// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/uio.h>

#include <array>
#include <cstddef>

#include "posix/file_descriptor.h"
#include "posix/hot.h"

namespace tzc {
namespace posix {

constexpr std::size_t max_passed_descriptors = 2;

enum class SendResult {
  sent,
  full,       ///< the socket takes no more now; nothing was sent
  exhausted,  ///< the system has no memory, or too many descriptors are in flight; nothing was sent, and the
              ///< socket does not tell when it passes
  gone,       ///< the peer is no longer there, or the socket is broken
};

/// Sends one packet, and descriptors along with it. Never blocks, never raises SIGPIPE.
TZC_HOT SendResult send_packet(int socket, const iovec* parts, std::size_t part_count,
                               const int* descriptors = nullptr, std::size_t descriptor_count = 0) noexcept;

/// The same for a packet that lies in one piece.
TZC_HOT SendResult send_packet(int socket, const void* data, std::size_t size) noexcept;

enum class Waiting { block, return_at_once };

enum class ReceiveResult {
  packet,
  nothing,  ///< nothing there now (return_at_once only)
  closed,   ///< the peer closed its end and everything it sent was read, or the socket is broken
};

struct ReceivedPacket {
  std::size_t size = 0;
  bool truncated = false;         ///< the packet did not fit the memory given
  bool descriptors_lost = false;  ///< some could not be received: more than allowed, or too many open files
  std::array<FileDescriptor, max_passed_descriptors> descriptors;
  std::size_t descriptor_count = 0;
};

/// Whether everything was read that came through the socket, and nothing more can come. Never blocks.
bool is_at_end(int socket) noexcept;

/// Receives one packet into [memory, memory + size). Descriptors beyond what `with_descriptors` allows are
/// closed by the kernel and never reach this process.
ReceiveResult receive_packet(int socket, void* memory, std::size_t size, Waiting waiting,
                             bool with_descriptors, ReceivedPacket& packet) noexcept;
/// The same into several pieces of memory, one after the other.
TZC_HOT ReceiveResult receive_packet(int socket, const iovec* parts, std::size_t part_count, Waiting waiting,
                                     bool with_descriptors, ReceivedPacket& packet) noexcept;

}  // namespace posix
}  // namespace tzc
