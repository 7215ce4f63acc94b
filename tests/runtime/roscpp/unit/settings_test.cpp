// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/settings.h"

#include <gtest/gtest.h>

#include "support/text.h"

namespace tzc {
namespace detail {
namespace {

using test::has;

struct Parsed {
  Settings settings;
  std::vector<std::string> warnings;
};

Parsed parse(std::map<std::string, std::string> parameters,
             std::map<std::string, std::string> environment = {}) {
  Parsed parsed;
  parsed.settings = parse_settings({std::move(parameters), std::move(environment), {}}, parsed.warnings);
  return parsed;
}

/// The only warning about this parameter.
std::string warning(const std::string& name, const std::string& text) {
  const Parsed parsed = parse({{name, text}});
  EXPECT_EQ(parsed.warnings.size(), 1u) << name << " " << text;
  return parsed.warnings.empty() ? std::string() : parsed.warnings.front();
}

TEST(Settings, nothing_set_is_nothing_overridden) {
  const Parsed parsed = parse({});
  EXPECT_TRUE(parsed.warnings.empty());
  PublisherOptions in_code;
  in_code.memory_size = 123;
  in_code.policy = Policy::best_effort();
  const PublisherOptions options = overridden(in_code, parsed.settings);
  EXPECT_EQ(options.memory_size, 123u);
  EXPECT_EQ(options.policy.kind, PolicyKind::best_effort);
  EXPECT_EQ(options.policy.attempts, 0u);
  EXPECT_EQ(parsed.settings.upgrade_attempts, 10);
  EXPECT_TRUE(parsed.settings.private_writes);
  EXPECT_TRUE(parsed.settings.statistics_page);
  EXPECT_FALSE(parsed.settings.memory_ceiling);
}

TEST(Settings, each_of_them) {
  const Parsed parsed = parse({{"disable", "1"},
                               {"disable_topics", "/a, /b\t/c"},
                               {"private_writes", "off"},
                               {"statistics_page", "no"},
                               {"memory_size", "64M"},
                               {"memory_ceiling", "2G"},
                               {"policy", "worst_effort"},
                               {"policy_attempts", "7"},
                               {"prefault", "all"},
                               {"on_exhausted", "drop"},
                               {"upgrade_attempts", "3"}});
  EXPECT_TRUE(parsed.warnings.empty()) << parsed.warnings.front();
  EXPECT_TRUE(parsed.settings.disable);
  EXPECT_FALSE(parsed.settings.private_writes);
  EXPECT_FALSE(parsed.settings.statistics_page);
  EXPECT_EQ(parsed.settings.disable_topics, (std::set<std::string>{"/a", "/b", "/c"}));
  EXPECT_EQ(parsed.settings.upgrade_attempts, 3);
  EXPECT_EQ(parsed.settings.memory_ceiling, std::size_t{2} << 30);
  const PublisherOptions options = overridden(PublisherOptions(), parsed.settings);
  EXPECT_EQ(options.memory_size, std::size_t{64} << 20);
  EXPECT_EQ(options.policy.kind, PolicyKind::worst_effort);
  EXPECT_EQ(options.policy.attempts, 7u);
  EXPECT_EQ(options.prefault, Prefault::all);
  EXPECT_EQ(options.on_exhausted, OnExhausted::drop);
}

TEST(Settings, a_parameter_wins_over_the_environment) {
  EXPECT_EQ(parse({{"memory_size", "1000"}}, {{"memory_size", "2000"}}).settings.memory_size, 1000u);
  EXPECT_EQ(parse({}, {{"memory_size", "2000"}}).settings.memory_size, 2000u);
  EXPECT_EQ(parse({{"tries", "4"}}, {{"upgrade_attempts", "5"}}).settings.upgrade_attempts, 4);
}

TEST(Settings, sizes) {
  const std::map<std::string, std::size_t> sizes = {{"0", 0},
                                                    {"1000", 1000},
                                                    {"4K", 4096},
                                                    {"4k", 4096},
                                                    {"4KB", 4096},
                                                    {"4KiB", 4096},
                                                    {"2M", 2u << 20},
                                                    {"1G", 1u << 30},
                                                    {"100B", 100},
                                                    {"4294967296", std::size_t{1} << 32},
                                                    {"8G", std::size_t{8} << 30}};
  for (const auto& size : sizes) {
    const Parsed parsed = parse({{"memory_size", size.first}});
    EXPECT_TRUE(parsed.warnings.empty()) << size.first;
    EXPECT_EQ(parsed.settings.memory_size, size.second) << size.first;
  }
  for (const char* wrong :
       {"M", "-1", "1.5M", "64MM", "64 M", "lots", "1T", "99999999999999999999", "99999999999G"}) {
    EXPECT_TRUE(has(warning("memory_size", wrong), "must be a whole number")) << wrong;
    EXPECT_FALSE(parse({{"memory_size", wrong}}).settings.memory_size) << wrong;
  }
}

TEST(Settings, an_unknown_parameter_names_the_near_one) {
  EXPECT_TRUE(has(warning("memorysize", "1"), "~tzc/memorysize is not a parameter of TZC"));
  EXPECT_TRUE(has(warning("memorysize", "1"), "did you mean ~tzc/memory_size?"));
  EXPECT_TRUE(has(warning("polcy", "best_effort"), "did you mean ~tzc/policy?"));
  EXPECT_TRUE(has(warning("disable_topic", "/a"), "did you mean ~tzc/disable_topics?"));
  EXPECT_FALSE(has(warning("colour", "red"), "did you mean"));
}

TEST(Settings, a_wrong_word_names_the_valid_ones) {
  const std::string text = warning("policy", "besteffort");
  EXPECT_TRUE(has(text, "~tzc/policy cannot be 'besteffort'"));
  EXPECT_TRUE(has(text, "best_effort, medium_effort or worst_effort"));
  EXPECT_TRUE(has(text, "did you mean best_effort?"));
  EXPECT_TRUE(has(warning("prefault", "al"), "none, on_first_use or all"));
  EXPECT_TRUE(has(warning("on_exhausted", "block"), "deliver or drop"));
  EXPECT_TRUE(has(warning("disable", "perhaps"), "0, 1"));
  EXPECT_TRUE(has(warning("upgrade_attempts", "ten"), "must be a whole number"));
  EXPECT_EQ(parse({{"upgrade_attempts", "-3"}}).settings.upgrade_attempts, 10);
  EXPECT_FALSE(parse({{"policy_attempts", "few"}}).settings.policy_attempts);
}

TEST(Settings, a_topic_that_is_no_resolved_name_is_said_and_ignored) {
  const Parsed parsed = parse({{"disable_topics", "/a image"}});
  EXPECT_EQ(parsed.settings.disable_topics, (std::set<std::string>{"/a"}));
  ASSERT_EQ(parsed.warnings.size(), 1u);
  EXPECT_TRUE(has(parsed.warnings.front(), "~tzc/disable_topics names the topic 'image'"));
}

TEST(Settings, a_variable_that_looks_like_a_slip_is_said) {
  std::vector<std::string> warnings;
  SettingTexts texts;
  texts.other_variables = {"TZC_MEMROY_SIZE", "TZC_GARD",       "TZC_GUARD",
                           "TZC_TRACE",       "TZC_ROBOT_NAME", "TZC_RUN"};
  parse_settings(texts, warnings);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(has(warnings[0], "TZC_MEMROY_SIZE")) << warnings[0];
  EXPECT_TRUE(has(warnings[0], "did you mean TZC_MEMORY_SIZE?")) << warnings[0];
  EXPECT_TRUE(has(warnings[1], "did you mean TZC_GUARD?")) << warnings[1];
}

TEST(Settings, a_variable_is_named_as_one) {
  const Parsed parsed = parse({}, {{"policy", "best"}});
  ASSERT_EQ(parsed.warnings.size(), 1u);
  EXPECT_TRUE(has(parsed.warnings.front(), "TZC_POLICY cannot be 'best'"));
}

TEST(Settings, old_names_are_accepted_with_a_warning) {
  const Parsed parsed = parse({{"attempts", "9"}}, {{"tries", "2"}});
  EXPECT_EQ(parsed.settings.policy_attempts, 9u);
  EXPECT_EQ(parsed.settings.upgrade_attempts, 2);
  ASSERT_EQ(parsed.warnings.size(), 2u);
  EXPECT_TRUE(has(parsed.warnings[0], "~tzc/attempts is now called ~tzc/policy_attempts"));
  EXPECT_TRUE(has(parsed.warnings[1], "TZC_TRIES is now called TZC_UPGRADE_ATTEMPTS"));
}

TEST(Settings, another_policy_comes_with_its_own_attempts) {
  PublisherOptions in_code;
  in_code.policy = Policy::best_effort();
  const PublisherOptions other = overridden(in_code, parse({{"policy", "medium_effort"}}).settings);
  EXPECT_EQ(other.policy.attempts, Policy().attempts);
  in_code.policy = Policy::medium_effort(5);
  EXPECT_EQ(overridden(in_code, parse({{"policy", "medium_effort"}}).settings).policy.attempts, 5u);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
