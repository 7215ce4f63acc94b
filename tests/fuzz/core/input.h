// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/socket.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "posix/file_descriptor.h"
#include "posix/packet.h"

namespace tzc {
namespace fuzz {

/// Reads a fuzzer's bytes as values; zero once they are used up.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  template <class T>
  T take() {
    T value{};
    take_into(&value, sizeof value);
    return value;
  }

  void take_into(void* to, std::size_t count) {
    const std::size_t have = std::min(count, size_);
    if (have == 0) return;
    std::memcpy(to, data_, have);
    data_ += have;
    size_ -= have;
  }

  std::vector<std::uint8_t> take_bytes(std::size_t count) {
    std::vector<std::uint8_t> bytes(std::min(count, size_));
    take_into(bytes.data(), bytes.size());
    return bytes;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

struct SocketPair {
  posix::FileDescriptor ours, theirs;

  SocketPair() {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) __builtin_trap();
    ours = posix::FileDescriptor(ends[0]);
    theirs = posix::FileDescriptor(ends[1]);
  }

  posix::SendResult send(const void* data, std::size_t size, std::vector<int> descriptors = {}) const {
    const iovec part{const_cast<void*>(data), size};
    return posix::send_packet(ours.get(), &part, 1, descriptors.data(), descriptors.size());
  }
};

}  // namespace fuzz
}  // namespace tzc
