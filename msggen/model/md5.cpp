// SPDX-License-Identifier: BSD-3-Clause
#include "model/md5.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace tzc::msggen {
namespace {

using State = std::array<std::uint32_t, 4>;

// RFC 1321, section 3.4: the integer part of 4294967296 times abs(sin(i)), i in radians.
std::array<std::uint32_t, 64> sine_table() {
  std::array<std::uint32_t, 64> table{};
  for (int i = 0; i < 64; ++i)
    table[i] = static_cast<std::uint32_t>(std::fabs(std::sin(i + 1.0)) * 4294967296.0);
  return table;
}

constexpr int rotations[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};

std::uint32_t rotate_left(std::uint32_t x, int n) {
  return (x << n) | (x >> (32 - n));
}

std::uint32_t word_at(const unsigned char* p) {
  return std::uint32_t{p[0]} | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16 |
         std::uint32_t{p[3]} << 24;
}

struct Mix {
  std::uint32_t value;
  int word;
};

Mix mix(int i, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  switch (i / 16) {
    case 0:
      return {(b & c) | (~b & d), i};
    case 1:
      return {(d & b) | (~d & c), (5 * i + 1) % 16};
    case 2:
      return {b ^ c ^ d, (3 * i + 5) % 16};
    default:
      return {c ^ (b | ~d), (7 * i) % 16};
  }
}

void add_block(State& state, const unsigned char* block) {
  static const auto sines = sine_table();
  auto [a, b, c, d] = state;
  for (int i = 0; i < 64; ++i) {
    Mix m = mix(i, b, c, d);
    std::uint32_t sum = a + m.value + sines[i] + word_at(block + 4 * m.word);
    a = d;
    d = c;
    c = b;
    b += rotate_left(sum, rotations[i / 16][i % 4]);
  }
  state = {state[0] + a, state[1] + b, state[2] + c, state[3] + d};
}

std::string padded(std::string_view bytes) {
  std::string text(bytes);
  text += '\x80';
  text.append((120 - text.size() % 64) % 64, '\0');
  std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
  for (int i = 0; i < 8; ++i) text += static_cast<char>(bits >> (8 * i) & 0xFF);
  return text;
}

}  // namespace

std::string md5_hex(std::string_view bytes) {
  State state = {0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
  std::string text = padded(bytes);
  const auto* p = reinterpret_cast<const unsigned char*>(text.data());
  for (std::size_t i = 0; i < text.size(); i += 64) add_block(state, p + i);
  std::string hex;
  for (std::uint32_t word : state) {
    for (int i = 0; i < 4; ++i) hex += fmt::format("{:02x}", word >> (8 * i) & 0xFF);
  }
  return hex;
}

}  // namespace tzc::msggen
