// SPDX-License-Identifier: BSD-3-Clause
#include "posix/memory_budget.h"

#include <gtest/gtest.h>

#include <utility>

#include "posix/memory_file.h"

namespace tzc {
namespace posix {
namespace {

constexpr std::size_t mb = std::size_t{1} << 20, page = 4096;
using Clock = HeadroomAllowance::Clock;

TEST(ReservedBytes, are_counted_once_wherever_the_file_goes) {
  const std::size_t before = reserved_memory();
  {
    auto created = create_memory_file("test", mb, Sharing::peers_write);
    ASSERT_TRUE(created);
    MemoryFile file = std::move(*created);
    ASSERT_TRUE(reserve(file, 0, mb));
    EXPECT_EQ(reserved_memory(), before + mb);
    MemoryFile moved = std::move(file);
    EXPECT_EQ(reserved_memory(), before + mb);
    moved = MemoryFile();
    EXPECT_EQ(reserved_memory(), before);
  }
  EXPECT_EQ(reserved_memory(), before);
}

TEST(ReservedBytes, of_a_reserve_that_is_refused_are_not_counted) {
  const std::size_t before = reserved_memory();
  auto file = create_memory_file("test", mb, Sharing::peers_write);
  ASSERT_TRUE(file);
  set_memory_ceiling(before + mb / 2);
  EXPECT_FALSE(reserve(*file, 0, mb));
  EXPECT_EQ(reserved_memory(), before);
  EXPECT_TRUE(reserve(*file, 0, mb / 2));
  EXPECT_FALSE(reserve(*file, mb / 2, page));
  set_memory_ceiling(0);
  EXPECT_FALSE(reserve(*file, mb / 2, page)) << "a ceiling below what is taken already";
  set_memory_ceiling(SIZE_MAX);
  EXPECT_TRUE(reserve(*file, mb / 2, page));
}

TEST(HeadroomAllowance, serves_many_small_commits_with_one_look) {
  HeadroomAllowance allowance;
  const Clock::time_point now = Clock::now();
  int looks = 0;
  for (int i = 0; i < 1'000; ++i) {
    if (allowance.take(page, now)) continue;
    ++looks;
    allowance.refill(1024 * mb, page, now);
  }
  EXPECT_EQ(looks, 1);
}

TEST(HeadroomAllowance, is_a_small_part_of_what_was_there) {
  HeadroomAllowance allowance;
  const Clock::time_point now = Clock::now();
  allowance.refill(16 * mb + page, page, now);
  EXPECT_FALSE(allowance.take(mb + 1, now));
  EXPECT_TRUE(allowance.take(mb, now));
  EXPECT_FALSE(allowance.take(1, now));
  allowance.refill(SIZE_MAX, page, now);
  EXPECT_FALSE(allowance.take(HeadroomAllowance::most_bytes + 1, now));
  EXPECT_TRUE(allowance.take(HeadroomAllowance::most_bytes, now));
}

TEST(HeadroomAllowance, is_nothing_where_nothing_is_left_and_ends_soon) {
  HeadroomAllowance allowance;
  const Clock::time_point now = Clock::now();
  EXPECT_FALSE(allowance.take(page, now)) << "before the first look";
  allowance.refill(page, page, now);
  EXPECT_FALSE(allowance.take(1, now));
  allowance.refill(1024 * mb, page, now);
  EXPECT_FALSE(allowance.take(page, now + HeadroomAllowance::lifetime));
}

}  // namespace
}  // namespace posix
}  // namespace tzc
