// SPDX-License-Identifier: BSD-3-Clause
#include "message_pattern.h"

#include <cstring>
#include <random>

namespace tzc {
namespace crash {
namespace {

struct Control {
  std::uint64_t seed;
  std::uint32_t blocks;
  std::uint32_t bytes[3];
};

Control plan(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Control control{seed, static_cast<std::uint32_t>(1 + random() % 3), {}};
  for (std::uint32_t& bytes : control.bytes) bytes = static_cast<std::uint32_t>(8 * (1 + random() % 8000));
  return control;
}

std::uint64_t next(std::uint64_t& state) {  // xorshift: fast enough to check every byte
  state ^= state << 13;
  state ^= state >> 7;
  return state ^= state << 17;
}

std::uint64_t start_of(const Control& control, std::uint32_t block) {
  return (control.seed + 1) * 31 + block;
}

void fill(std::uint8_t* data, std::size_t bytes, std::uint64_t state) {
  for (std::size_t i = 0; i < bytes; i += 8) {
    const std::uint64_t word = next(state);
    std::memcpy(data + i, &word, 8);
  }
}

bool matches(const std::uint8_t* data, std::size_t bytes, std::uint64_t state) {
  for (std::size_t i = 0; i < bytes; i += 8) {
    const std::uint64_t word = next(state);
    if (std::memcmp(data + i, &word, 8) != 0) return false;
  }
  return true;
}

}  // namespace

channel::RecordPtr make_patterned(SegmentMemory& memory, std::uint64_t seed) {
  const Control control = plan(seed);
  std::vector<BufferPtr> buffers;
  for (std::uint32_t i = 0; i < control.blocks; ++i) {
    BufferPtr buffer = memory.allocate(control.bytes[i]);
    if (!buffer) return nullptr;
    fill(buffer->data(), control.bytes[i], start_of(control, i));
    buffers.push_back(std::move(buffer));
  }
  return channel::make_record(1, &control, sizeof control, buffers);
}

bool is_intact(const channel::Message& message) {
  Control control{};
  if (message.control_size() != sizeof control) return false;
  std::memcpy(&control, message.control(), sizeof control);
  const Control expected = plan(control.seed);
  if (std::memcmp(&control, &expected, sizeof control) != 0 || message.blocks().size() != control.blocks)
    return false;
  for (std::uint32_t i = 0; i < control.blocks; ++i) {
    const ConstBlock& block = message.blocks()[i];
    if (block.size < control.bytes[i] || !matches(block.data, control.bytes[i], start_of(control, i)))
      return false;
  }
  return true;
}

}  // namespace crash
}  // namespace tzc
