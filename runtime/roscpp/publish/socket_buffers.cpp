// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/socket_buffers.h"

#include <algorithm>
#include <fstream>

#include "roscpp/megabyte.h"

namespace tzc {
namespace detail {
namespace {

/// The last of three numbers: "4096 131072 6291456".
std::size_t most_bytes(const char* setting, std::size_t otherwise) {
  std::ifstream file(setting);
  std::size_t least = 0, initial = 0, most = 0;
  return file >> least >> initial >> most ? most : otherwise;
}

std::size_t measure() {
  const std::size_t buffers =
      std::min(most_bytes("/proc/sys/net/ipv4/tcp_rmem", 6 * kMegabyte), 64 * kMegabyte) +
      std::min(most_bytes("/proc/sys/net/ipv4/tcp_wmem", 4 * kMegabyte), 64 * kMegabyte);
  return std::min(buffers + buffers / 8 + kMegabyte, 64 * kMegabyte);
}

}  // namespace

std::size_t room_for_a_burst() {
  static const std::size_t room = measure();
  return room;
}

}  // namespace detail
}  // namespace tzc
