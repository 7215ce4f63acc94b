// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "channel/wire/record.h"
#include "channel/wire/small_vector.h"
#include "segment/block.h"

namespace tzc {
namespace channel {

/// The records of one connection that are in flight, oldest first. Holds no handles: once a record is
/// written, only its block words keep its blocks. Not thread-safe.
///
/// A ring whose entries keep their memory: the steady state allocates and moves nothing.
class InFlightRecords {
 public:
  struct Entry {
    std::uint32_t sequence = 0;
    std::size_t bytes = 0;                     // what it counts for against the limit
    SmallVector<segment::BlockName, 2> marks;  // the blocks that are marked for it
    std::vector<std::uint8_t> body;            // its body, if kept; names its blocks without keeping them
    RecordPtr record;  // instead of the body of a record without blocks, which may be large
  };

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Entry& oldest() const { return at(0); }
  /// By age, 0 is the oldest.
  const Entry& at(std::size_t index) const { return ring_[(first_ + index) & (ring_.size() - 1)]; }
  /// A new youngest entry without marks.
  Entry& push(std::uint32_t sequence) {
    if (size_ == ring_.size()) grow();
    Entry& entry = ring_[(first_ + size_++) & (ring_.size() - 1)];
    entry.sequence = sequence;
    return entry;
  }
  void drop_oldest();
  /// The youngest entry that refers to the block; null when there is none.
  const Entry* find_last(const segment::BlockName& block) const;

 private:
  void grow();

  std::vector<Entry> ring_;  // its size is a power of two
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace channel
}  // namespace tzc
