// SPDX-License-Identifier: BSD-3-Clause
// Takes away one rule, or one step of the engine, at a time: some golden case must notice. A rule that no
// case needs is a rule that no test holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "golden/case.h"
#include "rules/rule.h"

namespace tzc::rewriter::test {
namespace {

/// Whether the port without the rule or step is another than the case expects. The check that no call is
/// missing from the report is off: it would stop the run before there is a port to compare.
bool notices(const std::string& path, const std::string& without) {
  const Case one = read_case(path);
  const Package package = package_of(one);
  EngineOptions options = package.options(one.settings);
  options.without_rules.insert({without, "completeness"});
  const Expected<PortPlan> plan = plan_port(options);
  EXPECT_TRUE(plan) << path << ": " << to_string(plan.error());
  return plan && describe(package, one, *plan) != one.golden.expected();
}

std::string case_path(const std::string& name) {
  return std::string(TZC_CASES) + "/" + name + ".cpp";
}

/// Rule -> the cases' names that are likely to need it, found by what stands in them.
std::string case_for(const RuleSet& rules, const std::string& rule) {
  std::string written;
  for (const ClassRename* one : rules.classes)
    if (rule == one->rule) written = one->to;
  for (const LibraryCall* one : rules.calls)
    if (rule == one->rule) written = std::string(one->to) + "(";
  for (const MethodCall* one : rules.methods)
    if (rule == one->rule) written = one->to;
  for (const MethodCall* one : rules.filters)
    if (rule == one->rule) written = one->to;
  for (const LibraryAdvertise* one : rules.advertisers)
    if (rule == one->rule) written = one->to;
  for (const std::string& path : tzc::test::GoldenCase::all(TZC_CASES, ".cpp")) {
    if (read_case(path).golden.expected().find(written) == std::string::npos) continue;
    if (notices(path, rule)) return path;
  }
  return "";
}

std::vector<std::string> rule_names() {
  const RuleSet rules = all_rules();
  std::vector<std::string> names;
  for (const ClassRename* one : rules.classes) names.push_back(one->rule);
  for (const LibraryCall* one : rules.calls) names.push_back(one->rule);
  for (const MethodCall* one : rules.methods) names.push_back(one->rule);
  for (const MethodCall* one : rules.filters) names.push_back(one->rule);
  for (const LibraryAdvertise* one : rules.advertisers) names.push_back(one->rule);
  return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class Rule : public ::testing::TestWithParam<std::string> {};

TEST_P(Rule, is_needed_by_a_case) {
  EXPECT_NE(case_for(all_rules(), GetParam()), "") << "no case needs " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Mutation, Rule, ::testing::ValuesIn(rule_names()), test_name);

/// Without its rule a call is not collected: the second look must notice, whatever else the case compares.
TEST(Mutation, a_call_that_is_not_collected_is_named) {
  for (const std::string rule : {"advertise", "subscribe"}) {
    const Case one =
        read_case(case_path(rule == "advertise" ? "zero_copy/local_resize" : "shared/subscribe_forms"));
    const Package package = package_of(one);
    EngineOptions options = package.options(one.settings);
    options.without_rules.insert(rule);
    const Expected<PortPlan> plan = plan_port(options);
    ASSERT_FALSE(plan) << rule;
    EXPECT_NE(plan.error().what.find("this " + rule + " call is not in it"), std::string::npos)
        << plan.error().what;
    EXPECT_EQ(plan.error().where.rfind("src/node.cpp:", 0), 0u) << plan.error().where;
  }
}

TEST(Mutation, nothing_is_noticed_when_nothing_is_taken_away) {
  for (const char* name : {"zero_copy/local_resize", "shared/subscribe_forms", "one_copy/kept_received"})
    EXPECT_FALSE(notices(case_path(name), "no rule")) << name;
}

TEST(Mutation, verification_is_needed) {
  EXPECT_TRUE(notices(case_path("one_copy/library_takes_vector"), "verification"));
  EXPECT_TRUE(notices(case_path("one_copy/another_overload_pointer"), "verification"));
}

TEST(Mutation, all_or_nothing_is_needed) {
  EXPECT_TRUE(notices(case_path("one_copy/two_units_one_header"), "all-or-nothing"));
  EXPECT_TRUE(notices(case_path("one_copy/kept_received"), "all-or-nothing"));
}

}  // namespace
}  // namespace tzc::rewriter::test
