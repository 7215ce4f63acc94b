// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/held_since.h"

#include <algorithm>

namespace tzc {
namespace detail {

void HeldSince::begin(std::uint64_t now_ms) {
  now_ms_ = now_ms;
  before_.swap(now_);
  now_.clear();
}

std::uint64_t HeldSince::oldest_ms(const std::vector<channel::HeldBlock>& held) {
  std::uint64_t oldest = 0;
  for (const channel::HeldBlock& block : held) {
    const Key key(block.file, block.slot, block.generation);
    const auto known = before_.find(key);
    const std::uint64_t since = known != before_.end() ? known->second : now_ms_;
    now_.emplace(key, since);
    oldest = std::max(oldest, now_ms_ - since);
  }
  return oldest;
}

}  // namespace detail
}  // namespace tzc
