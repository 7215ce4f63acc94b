// SPDX-License-Identifier: BSD-3-Clause
#include "segment/live_blocks.h"

#include <iterator>
#include <utility>

namespace tzc {
namespace segment {
namespace {

// Generations start shortly before they wrap around, so that every run exercises it (decision 105).
constexpr std::uint32_t first_generation = 0xffffffff - 2;

}  // namespace

Block* LiveBlocks::take_slot() {
  if (!spare_slots_.empty()) {
    Block* block = spare_slots_.back();
    spare_slots_.pop_back();
    return block;
  }
  if (slots_.size() == most_slots_) return nullptr;
  if (spare_slots_.capacity() <= slots_.size()) spare_slots_.reserve(2 * (slots_.size() + 1));
  return &slots_.emplace_back(owner_, static_cast<std::uint32_t>(slots_.size()), first_generation);
}

void LiveBlocks::add(Block& block) {
  const std::lock_guard<std::mutex> lock(mutex_);
  nodes_.reserve(live_, live_.size() + 1);
  nodes_.add(live_, block.offset, &block);
}

Block* LiveBlocks::find(std::uint64_t position, std::size_t bytes) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto after = live_.upper_bound(position);
  if (after == live_.begin()) return nullptr;
  Block& block = *std::prev(after)->second;
  const std::uint64_t begin = block.offset;
  if (position < begin || position - begin > block.size() || bytes > block.size() - (position - begin))
    return nullptr;
  return add_handle_if_any(block.handles()) ? &block : nullptr;
}

Block* LiveBlocks::revive(std::uint64_t data_offset, const BlockName& name, bool& first) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = live_.find(data_offset);
  if (found == live_.end()) return nullptr;
  Block& block = *found->second;
  if (block.slot() != name.slot || block.generation() != name.generation) return nullptr;
  first = add_handle(block.handles());
  return &block;
}

}  // namespace segment
}  // namespace tzc
