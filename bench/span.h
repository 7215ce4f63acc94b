// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>

#include "measure.h"

namespace tzc {
namespace bench {

/// The begin of one message's latency: before it is allocated and filled (Setup::fills), or right before it is published.
/// Made by the publisher before it allocates.
class Span {
 public:
  Span(const Setup& setup, std::uint64_t index) : fills_(setup.fills), begin_{now_ns(), index} {}

  /// New content, where that belongs to the span; otherwise the message keeps what it has.
  void fill(void* data, std::size_t bytes) const {
    if (fills_) std::memset(data, static_cast<int>(begin_.index), bytes);
  }
  /// For the message: call it last before publishing.
  Stamp stamp() const { return fills_ ? begin_ : Stamp{now_ns(), begin_.index}; }

 private:
  const bool fills_;
  const Stamp begin_;
};

}  // namespace bench
}  // namespace tzc
