// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "segment/spare_nodes.h"

namespace tzc {
namespace segment {

/// The free ranges of an address space [begin, end): first fit by address, neighbours joined at once.
///
/// Fragmentation is bounded. Let M be the most bytes ever in use at a time, and n the ratio of the largest to
/// the smallest request. First fit by address then never needs more than M * (1 + log2 n) bytes (Robson,
/// "Worst case fragmentation of first fit and best fit storage allocation strategies", 1977, up to its
/// additive constant; best fit may need about M * n). With one size (n = 1) nothing is ever lost.
/// tests/runtime/segment/extents_test.cpp drives it with Robson's adversary and with random traffic.
///
/// A search begins where the first range of the request's size class may be, so that it does not pass again and again
/// over the small ranges that many messages of other sizes leave. Not thread-safe.
class Extents {
 public:
  static constexpr std::uint64_t none = ~std::uint64_t{0};

  Extents(std::uint64_t begin, std::uint64_t end);

  /// The lowest free range of that length that begins at a multiple of `alignment` (a power of two) and ends at or
  /// before `limit`; none when there is none.
  std::uint64_t allocate(std::uint64_t bytes, std::uint64_t limit = none, std::uint64_t alignment = 1);
  /// Gives back what allocate returned.
  void release(std::uint64_t offset, std::uint64_t bytes);

  std::uint64_t free_bytes() const { return free_bytes_; }
  std::uint64_t looked_at() const { return looked_at_; }  ///< free ranges, by all searches
  bool empty() const { return free_bytes_ == size_; }     ///< nothing is allocated

 private:
  using Map = std::map<std::uint64_t, std::uint64_t>;  // offset -> length

  void insert(std::uint64_t offset, std::uint64_t bytes);
  void note_range(std::uint64_t offset, std::uint64_t bytes);

  Map free_;
  SpareNodes<Map> nodes_;             // for a free range before and behind each that is in use
  std::size_t in_use_ = 0;            // ranges
  std::vector<std::uint64_t> first_;  // by the binary logarithm of a length: none that long begins below
  std::uint64_t size_;
  std::uint64_t free_bytes_;
  std::uint64_t looked_at_ = 0;
};

}  // namespace segment
}  // namespace tzc
