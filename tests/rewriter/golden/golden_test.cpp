// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "golden/case.h"
#include "remarks/invariant.h"

namespace tzc::rewriter::test {
namespace {

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, is_ported_as_written) {
  const Case one = read_case(GetParam());
  const Package package = package_of(one);
  const Expected<PortPlan> plan = plan_port(package.options(one.settings));
  const std::string found = plan ? describe(package, one, *plan) : "// error " + plan.error().what + "\n";
  EXPECT_EQ(found, one.golden.expected(found)) << GetParam();
  EXPECT_EQ(std::filesystem::path(GetParam()).parent_path().filename(), outcome(plan))
      << "the folder is wrong";
  if (plan) {
    EXPECT_TRUE(check_report(plan->report)) << to_string(check_report(plan->report).error());
  }
  if (!plan || plan->edits.empty()) return;

  // The output compiles on its own, and a second run finds nothing to do, and the same sites.
  Case after = one;
  after.files = ported(package, one, *plan);
  const Package ported_package = package_of(after);
  const Expected<PortPlan> again = plan_port(ported_package.options(one.settings));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_TRUE(again->edits.empty()) << "the second run edits again: " << again->edits[0].text;
  EXPECT_EQ(lasting_sites(*again), lasting_sites(*plan)) << "the second run reports other sites";
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, ::testing::ValuesIn(tzc::test::GoldenCase::all(TZC_CASES, ".cpp")),
                         [](const auto& info) {
                           return tzc::test::GoldenCase::test_name(TZC_CASES, info.param);
                         });

}  // namespace
}  // namespace tzc::rewriter::test
