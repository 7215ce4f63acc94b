// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "segment/layout.h"

namespace tzc {
namespace segment {

/// Rounds a payload size up so that messages of slightly different sizes reuse each other's blocks: to a
/// multiple of 1/16 of the largest power of two below it, at least a cache line. Wastes less than 1/16 of
/// what is asked for, plus a cache line; powers of two waste nothing.
inline std::size_t size_class(std::size_t bytes) {
  std::size_t step = cache_line;
  while (step <= bytes / 32) step *= 2;
  const std::size_t rounded = (bytes + step - 1) / step * step;
  return rounded == 0 ? cache_line : rounded;
}

/// Whether a payload has pages of its own.
inline bool has_own_pages(std::size_t bytes, std::size_t page) {
  return bytes >= page;
}

/// What a payload of that size occupies.
inline std::size_t occupied_bytes(std::size_t bytes, std::size_t page) {
  const std::size_t rounded = size_class(bytes);
  return has_own_pages(bytes, page) ? (rounded + page - 1) / page * page : rounded;
}

}  // namespace segment
}  // namespace tzc
