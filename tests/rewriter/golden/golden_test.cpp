// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "golden/case.h"

namespace tzc::rewriter::test {
namespace {

std::vector<std::string> all_cases() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TZC_CASES))
    if (entry.path().extension() == ".cpp") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = std::filesystem::relative(info.param, TZC_CASES).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, is_ported_as_written) {
  const Case one = read_case(GetParam());
  const Package package(one.files);
  const Expected<PortPlan> plan = plan_port(package.options(one.settings));
  const std::string found =
      plan ? describe(package, one, *plan) : "//===\n// error " + plan.error().what + "\n";
  if (std::getenv("TZC_UPDATE_GOLDEN"))
    write_expected(one, found);
  else
    EXPECT_EQ(found, one.expected) << GetParam();
  if (!plan || plan->edits.empty()) return;

  // The output compiles on its own, and a second run finds nothing to do, and the same sites.
  Case after = one;
  after.files = ported(package, one, *plan);
  const Package ported_package(after.files);
  const Expected<PortPlan> again = plan_port(ported_package.options(one.settings));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_TRUE(again->edits.empty()) << "the second run edits again: " << again->edits[0].text;
  EXPECT_EQ(lasting_sites(*again), lasting_sites(*plan)) << "the second run reports other sites";
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, ::testing::ValuesIn(all_cases()), test_name);

}  // namespace
}  // namespace tzc::rewriter::test
