// SPDX-License-Identifier: BSD-3-Clause
// The delivery cursors over many more records than their numbers can tell apart.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <random>

#include "channel/wire/delivery_cursors.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::uint64_t stride = 65535;  // as many records may be in flight
constexpr std::uint64_t first = 0xffffffff - 5;
constexpr std::uint64_t far = first + (std::uint64_t{3} << 32);

constexpr std::uint64_t cursors_at(std::uint64_t sequence) {
  const auto both = static_cast<std::uint32_t>(sequence);
  return pack(DeliveryCursors{both, both});
}

TEST(Cursors, without_a_revocation_every_record_is_taken) {
  std::atomic<std::uint64_t> word{cursors_at(first)};
  for (std::uint64_t sequence = first + 1; sequence < far; sequence += stride)
    ASSERT_TRUE(try_take(word, static_cast<std::uint32_t>(sequence))) << sequence - first << " records later";
}

TEST(Cursors, what_is_never_taken_is_always_revoked) {
  std::atomic<std::uint64_t> word{cursors_at(first)};
  for (std::uint64_t sequence = first + 1; sequence < far; sequence += stride) {
    std::uint32_t taken = 0;
    ASSERT_TRUE(try_revoke(word, static_cast<std::uint32_t>(sequence), taken)) << sequence - first;
    ASSERT_TRUE(is_after(static_cast<std::uint32_t>(sequence), taken)) << sequence - first;
    ASSERT_FALSE(try_take(word, static_cast<std::uint32_t>(sequence))) << sequence - first;
  }
}

// Against cursors that never wrap around.
TEST(Cursors, decide_as_numbers_without_end_would) {
  std::mt19937_64 random(1);
  std::atomic<std::uint64_t> word{cursors_at(first)};
  std::uint64_t revoked = first, taken = first, sequence = first;
  bool takes = true;
  while (sequence < far) {
    if (random() % 20000 == 0) takes = !takes;  // long runs of one side alone
    sequence += 1 + random() % stride;
    const auto short_sequence = static_cast<std::uint32_t>(sequence);
    std::uint32_t seen = 0;
    if (takes) {
      ASSERT_EQ(try_take(word, short_sequence), sequence > revoked);
      if (sequence > revoked) taken = sequence;
    } else {
      ASSERT_EQ(try_revoke(word, short_sequence, seen), sequence > taken);
      if (sequence > taken) revoked = sequence;
      ASSERT_FALSE(try_take(word, short_sequence)) << "revoked already";
    }
  }
}

}  // namespace
}  // namespace channel
}  // namespace tzc
