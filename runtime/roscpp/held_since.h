// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "channel/inspection.h"

namespace tzc {
namespace detail {

/// Since when blocks have been held, from looks at what is held: exact to the time between two looks, and nothing is done
/// for it when a block is taken or released. Used by one thread.
class HeldSince {
 public:
  /// Begins a look; what is not seen in it is not held any more.
  void begin(std::uint64_t now_ms);
  /// For how long the oldest of these has been held, in milliseconds; 0 without any.
  std::uint64_t oldest_ms(const std::vector<channel::HeldBlock>& held);

 private:
  using Key = std::tuple<const void*, std::uint32_t, std::uint32_t>;
  std::uint64_t now_ms_ = 0;
  std::map<Key, std::uint64_t> before_, now_;  ///< when each was seen first
};

}  // namespace detail
}  // namespace tzc
