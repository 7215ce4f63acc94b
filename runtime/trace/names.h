// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace tzc {
namespace trace {

/// What the trace calls the channel at an address: a topic, for example.
struct ChannelName {
  std::string topic;
  /// The subscriber there gives messages to callbacks of its own, later or on other threads, which the trace shows instead.
  bool passes_on = false;
};

/// The file for this process: `pattern` with its number for each %p, or PATTERN.PID when it has none. Pure.
std::string file_name(const std::string& pattern, std::uint32_t process);

}  // namespace trace
}  // namespace tzc
