// SPDX-License-Identifier: BSD-3-Clause
#include "segment/extents.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tzc {
namespace segment {
namespace {

std::size_t binary_logarithm(std::uint64_t bytes) {
  return static_cast<std::size_t>(63 - __builtin_clzll(bytes | 1));
}

}  // namespace

Extents::Extents(std::uint64_t begin, std::uint64_t end)
    : first_(binary_logarithm(end - begin) + 1), size_(end - begin), free_bytes_(end - begin) {
  if (begin < end) free_.emplace(begin, end - begin);
}

std::uint64_t Extents::allocate(std::uint64_t bytes, std::uint64_t limit, std::uint64_t alignment) {
  if (bytes > size_) return none;
  std::uint64_t& first = first_[binary_logarithm(bytes)];
  bool passed = false;  // a range that is long enough for the class
  for (auto at = free_.lower_bound(first); at != free_.end(); ++at) {
    ++looked_at_;
    const auto [offset, length] = *at;
    if (!passed) first = offset;
    passed = passed || binary_logarithm(length) >= binary_logarithm(bytes);
    if (offset >= limit || bytes > limit - offset) return none;  // later ones end even higher
    const std::uint64_t begin = (offset + alignment - 1) & ~(alignment - 1);
    const std::uint64_t skipped = begin - offset;
    if (skipped > length || length - skipped < bytes || begin > limit || bytes > limit - begin) continue;
    nodes_.reserve(free_, in_use_ + 2);
    ++in_use_;
    nodes_.remove(free_, at);
    if (skipped > 0) insert(offset, skipped);
    if (length > skipped + bytes) insert(begin + bytes, length - skipped - bytes);
    free_bytes_ -= bytes;
    return begin;
  }
  return none;
}

void Extents::release(std::uint64_t offset, std::uint64_t bytes) {
  free_bytes_ += bytes;
  --in_use_;
  auto next = free_.lower_bound(offset);
  if (next != free_.end() && offset + bytes == next->first) {
    bytes += next->second;
    next = nodes_.remove(free_, next);
  }
  if (next != free_.begin()) {
    const auto previous = std::prev(next);
    if (previous->first + previous->second == offset) {
      previous->second += bytes;
      return note_range(previous->first, previous->second);
    }
  }
  insert(offset, bytes);
}

void Extents::note_range(std::uint64_t offset, std::uint64_t bytes) {
  for (std::size_t i = 0; i <= binary_logarithm(bytes); ++i) first_[i] = std::min(first_[i], offset);
}

void Extents::insert(std::uint64_t offset, std::uint64_t bytes) {
  note_range(offset, bytes);
  nodes_.add(free_, offset, bytes);
}

}  // namespace segment
}  // namespace tzc
