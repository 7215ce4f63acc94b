// SPDX-License-Identifier: BSD-3-Clause
#include "segment/ack_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace tzc {
namespace segment {
namespace {

constexpr std::uint32_t most_slots = 65536;

TEST(AckFile, knows_what_was_sent_from_the_first_slot_to_the_last) {
  for (const std::uint32_t slots : {std::uint32_t{64}, most_slots}) {
    const auto file = *AckFile::create(slots);
    for (const std::uint32_t slot : {std::uint32_t{0}, slots / 2, slots - 1}) {
      EXPECT_FALSE(file->holds(slot, 7));
      EXPECT_TRUE(file->mark(slot, 7));
      EXPECT_TRUE(file->holds(slot, 7));
      EXPECT_FALSE(file->holds(slot, 8));
    }
    std::vector<std::uint32_t> sent;
    file->for_each_sent([&sent](std::uint32_t slot) { sent.push_back(slot); });
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{0, slots / 2, slots - 1}));
    file->revoke(0, 7);
    EXPECT_FALSE(file->holds(0, 7));
    EXPECT_FALSE(file->idle());
  }
}

// A sanitizer's own memory grows with each mapping.
#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)

std::size_t private_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, 8, "RssAnon:") == 0) return std::strtoul(line.c_str() + 8, nullptr, 10);
  return 0;
}

// 80 publishers of 64 MB with 8 subscribers each: a list of all slots would take 40 MB.
TEST(AckFile, takes_little_private_memory_for_slots_that_are_not_used) {
  std::vector<std::shared_ptr<AckFile>> files;
  const std::size_t before = private_kb();
  for (int i = 0; i < 100; ++i) {
    files.push_back(*AckFile::create(most_slots));
    files.back()->mark(3, 7);
    EXPECT_FALSE(files.back()->holds(most_slots - 1, 7));
  }
  EXPECT_LT(private_kb() - before, 100 * 16u);
}

#endif

}  // namespace
}  // namespace segment
}  // namespace tzc
