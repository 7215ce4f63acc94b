// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "segment/release_hints.h"

namespace tzc {
namespace segment {

/// Hints of this process's own releases: last handles, revoked marks, subscribers that are gone. add: any thread.
class OwnReleases {
 public:
  explicit OwnReleases(std::uint32_t slots)
      : slots_(slots), leaves_(new std::atomic<std::uint64_t>[hint_leaves(slots)]()), reader_(slots) {}

  void add(std::uint32_t slot) noexcept { add_hint(top_, leaves_[slot / 64], slot, slots_); }
  /// For the allocator alone.
  std::uint32_t next() {
    return reader_.next(top_, [this](std::uint32_t leaf) -> auto& { return leaves_[leaf]; });
  }

 private:
  const std::uint32_t slots_;
  std::atomic<std::uint64_t> top_{0};
  std::unique_ptr<std::atomic<std::uint64_t>[]> leaves_;
  HintReader reader_;
};

}  // namespace segment
}  // namespace tzc
