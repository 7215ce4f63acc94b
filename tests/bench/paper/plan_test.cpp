// SPDX-License-Identifier: BSD-3-Clause
#include "paper/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_up.h"

namespace {

using namespace tzc::bench;
using testing::ContainsRegex;

TEST(Plan, has_what_is_left_of_each_contender_and_the_most_memory_at_a_time) {
  Options options;
  options.rate = 10;
  options.count = 1000;
  options.rounds = 2;
  std::vector<CellResult> results{{{"a", 1 << 20, 1}, {}},
                                  {{"a", 2 << 20, 1}, {}},
                                  {{"b", 1 << 20, 1}, {}},
                                  {{"b", 1 << 20, 1, under_load}, {}}};
  for (const std::size_t round : {0, 1})
    results[2].rounds.emplace(round, tzc::test::made_up({std::vector<std::uint64_t>(500, 1)}));
  const std::string text = plan_text(options, results, [](const Cell& cell) { return 3 * cell.size_bytes; });
  EXPECT_THAT(text, ContainsRegex("\na  +2  +4  +4 minutes  +6 MB\n"));  // 4 x (2 s + 520 x 0.1 s)
  EXPECT_THAT(text, ContainsRegex("\nb  +1  +0  +-  +3 MB\n"));
  EXPECT_THAT(text, ContainsRegex("\nb, under load  +1  +2  +2 minutes  +3 MB\n"));
  EXPECT_THAT(text, ContainsRegex("\nall  +4  +6  +6 minutes  +6 MB\n"));
}

}  // namespace
