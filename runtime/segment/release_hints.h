// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

// A set of slots of which something was released: a subscriber, or the publisher's own threads, add to it, and the
// allocator empties it. So the allocator looks at the blocks that may have become free, and never again and again at
// those that are known to be kept.
//
//   top    bit g: group g of leaves is not empty
//   leaf   bit b of leaf i: slot 64 i + b
//
// A hint is added after the release, its leaf before its group; the allocator empties the group's bit, then the leaf,
// then looks at the block. So each release is seen, or its hint stays. A hint is only a hint: a peer that leaves it out
// keeps its own blocks until it hangs up, and one that forges it makes the allocator look in vain.
//
// Templated on the atomic type so that the model checker runs this very code (tests/model/hint_model.cpp).

namespace tzc {
namespace segment {

constexpr std::uint32_t no_slot = 0xffffffff;

/// How many leaves there are, and how many of them make a group.
constexpr std::uint32_t hint_leaves(std::uint32_t slots) {
  return (slots + 63) / 64;
}
constexpr std::uint32_t leaves_per_group(std::uint32_t slots) {
  return (hint_leaves(slots) + 63) / 64;
}

/// Adds a slot.
template <class Top, class Leaf>
void add_hint(Top& top, Leaf& leaf, std::uint32_t slot, std::uint32_t slots) {
  leaf.fetch_or(std::uint64_t{1} << slot % 64, std::memory_order_release);
  top.fetch_or(std::uint64_t{1} << slot / 64 / leaves_per_group(slots), std::memory_order_release);
}

/// Empties a set, slot by slot. `leaf_at(i)` gives leaf i. Used by one thread at a time.
class HintReader {
 public:
  explicit HintReader(std::uint32_t slots) : slots_(slots) {}

  /// no_slot: the set is empty, or was; at most one group is asked for before each answer.
  template <class Top, class LeafAt>
  std::uint32_t next(Top& top, LeafAt leaf_at) {
    if (groups_ == 0 && bits_ == 0 && leaf_ == end_) {
      if (top.load(std::memory_order_relaxed) == 0) return no_slot;
      groups_ = top.exchange(0, std::memory_order_acquire);
    }
    while (bits_ == 0) {
      if (leaf_ == end_ && !start_group()) return no_slot;
      if (leaf_ == end_) continue;
      auto&& leaf = leaf_at(leaf_++);
      if (leaf.load(std::memory_order_relaxed) != 0) bits_ = leaf.exchange(0, std::memory_order_acquire);
    }
    const auto bit = static_cast<std::uint32_t>(__builtin_ctzll(bits_));
    bits_ &= bits_ - 1;
    const std::uint32_t slot = (leaf_ - 1) * 64 + bit;
    return slot < slots_ ? slot : no_slot;
  }

 private:
  bool start_group() {
    if (groups_ == 0) return false;
    const auto group = static_cast<std::uint32_t>(__builtin_ctzll(groups_));
    groups_ &= groups_ - 1;
    const std::uint32_t first = group * leaves_per_group(slots_), leaves = hint_leaves(slots_);
    leaf_ = first < leaves ? first : leaves;
    end_ = first + leaves_per_group(slots_) < leaves ? first + leaves_per_group(slots_) : leaves;
    return true;
  }

  const std::uint32_t slots_;
  std::uint64_t groups_ = 0;  // taken out of `top`, to be looked at
  std::uint64_t bits_ = 0;    // taken out of leaf_ - 1, to be given out
  std::uint32_t leaf_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace segment
}  // namespace tzc
