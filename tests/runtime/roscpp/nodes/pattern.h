// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace tzc_test {

/// Bytes that tell the message's number and their own position, so that a torn, stale or shifted array shows.
inline std::uint8_t pattern_byte(std::size_t position, std::uint32_t number) {
  return static_cast<std::uint8_t>((position * 31 + position / 256 + number * 7) & 0xff);
}

inline void fill_pattern(std::uint8_t* bytes, std::size_t size, std::uint32_t number) {
  for (std::size_t i = 0; i < size; ++i) bytes[i] = pattern_byte(i, number);
}

inline bool has_pattern(const std::uint8_t* bytes, std::size_t size, std::uint32_t number) {
  for (std::size_t i = 0; i < size; ++i)
    if (bytes[i] != pattern_byte(i, number)) return false;
  return true;
}

}  // namespace tzc_test
