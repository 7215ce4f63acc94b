// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/held_since.h"

#include <gtest/gtest.h>

namespace tzc {
namespace detail {
namespace {

const int file = 0, other_file = 0;

TEST(HeldSince, the_oldest_counts_from_the_look_that_saw_it_first) {
  HeldSince since;
  since.begin(1000);
  EXPECT_EQ(since.oldest_ms({}), 0U);
  EXPECT_EQ(since.oldest_ms({{&file, 1, 7}}), 0U);
  since.begin(2000);
  EXPECT_EQ(since.oldest_ms({{&file, 1, 7}, {&file, 2, 1}}), 1000U);
  EXPECT_EQ(since.oldest_ms({{&other_file, 1, 7}}), 0U);
  since.begin(4000);
  EXPECT_EQ(since.oldest_ms({{&file, 2, 1}}), 2000U);
}

TEST(HeldSince, a_block_that_was_used_again_is_another_one) {
  HeldSince since;
  since.begin(1000);
  since.oldest_ms({{&file, 1, 7}});
  since.begin(2000);
  EXPECT_EQ(since.oldest_ms({{&file, 1, 8}}), 0U);
}

TEST(HeldSince, what_a_look_did_not_see_begins_anew) {
  HeldSince since;
  since.begin(1000);
  since.oldest_ms({{&file, 1, 7}});
  since.begin(2000);
  since.begin(3000);
  EXPECT_EQ(since.oldest_ms({{&file, 1, 7}}), 0U);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
