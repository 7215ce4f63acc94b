// SPDX-License-Identifier: BSD-3-Clause
// What --check says, and what it accepts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/codes.h"
#include "tool/cli_case.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using test::Cli;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(Cli, check_is_silent_about_the_diff) {
  const auto result = ws.rewrite({"--check"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, Not(HasSubstr("@@")));
  EXPECT_FALSE(is_ported());
  ws.rewrite({"--apply"});
  EXPECT_EQ(ws.rewrite({"--check"}).status, 0);
}

/// The red CI of a package that could be ported: what fails the check is in the file for code scanning.

TEST_F(Cli, check_names_each_site_that_could_be_ported_in_sarif) {
  const std::string sarif = ws.folder() / "tzc.sarif";
  const auto results = [&] { return json::parse(ws.folder().read("tzc.sarif"))["runs"][0]["results"]; };
  EXPECT_EQ(ws.rewrite({"--check", "--report", sarif}).status, 1);
  json pending;
  for (const json& result : results())
    if (result["ruleId"] == codes::TZC5001) pending = result;
  ASSERT_FALSE(pending.is_null()) << results();
  EXPECT_EQ(pending["locations"][0]["physicalLocation"]["region"]["startLine"], 2);
  EXPECT_EQ(pending["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "src/node.cpp");
  EXPECT_EQ(pending["fixes"][0]["artifactChanges"].size(), 3u);
  ws.rewrite({"--apply"});
  ws.rewrite({"--check", "--report", sarif});
  EXPECT_THAT(results(), IsEmpty());
}

TEST_F(Cli, check_names_a_build_file_when_only_that_is_left) {
  ws.plan()["sites"][0]["pending"] = false;
  const std::string sarif = ws.folder() / "tzc.sarif";
  EXPECT_EQ(ws.rewrite({"--check", "--report", sarif}).status, 1);
  EXPECT_THAT(ws.folder().read("tzc.sarif"), HasSubstr("TZC5001"));
}

TEST_F(Cli, sarif_takes_paths_from_the_top_of_the_repository) {
  ASSERT_EQ(ws.shell("git init -q ."), 0);
  ws.rewrite({"--check", "--report", ws.folder() / "tzc.sarif"});
  const json run = json::parse(ws.folder().read("tzc.sarif"))["runs"][0];
  EXPECT_THAT(run["originalUriBaseIds"]["SRCROOT"]["uri"], StartsWith("file://"));
  for (const json& result : run["results"])
    for (const json& location : result["locations"])
      EXPECT_THAT(location["physicalLocation"]["artifactLocation"]["uri"], StartsWith("src/demo/"));
}

TEST_F(Cli, a_refusal_is_work_left_until_it_is_suppressed) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = {refusal()};
  EXPECT_EQ(ws.rewrite({"--check"}).status, 1);
  ws.folder().write("ws/src/demo/src/node.cpp",
                    "\n\nint x;  // tzc-ignore[TZC1001]: the driver wants it so\n");
  const auto result = ws.rewrite({"--check"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, HasSubstr("(suppressed: the driver wants it so)"));
}

TEST_F(Cli, a_baseline_accepts_what_it_knows_and_nothing_else) {
  ws.plan()["edits"] = json::array();
  ws.plan()["sites"] = {refusal()};
  const std::string baseline = ws.folder() / "baseline.json";
  ws.rewrite({"--report", baseline});
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 0);
  json other = refusal();
  other["id"] = "publish:src/node.cpp:main:2";
  other["line"] = 4;
  ws.plan()["sites"].push_back(other);
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 1);
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", ws.folder() / "none.json"}).status, 2);
}

TEST_F(Cli, a_baseline_need_not_list_what_is_ported_already) {
  const std::string baseline = ws.folder() / "baseline.json";
  ws.rewrite({"--report", baseline});  // lists the site that can be ported
  json other = ws.plan()["sites"][0];
  other["id"] = "publish:src/node.cpp:main:1";
  other["line"] = 3;
  other["pending"] = false;
  ws.plan()["sites"].push_back(other);
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 0);
  ws.plan()["sites"][1]["pending"] = true;
  EXPECT_EQ(ws.rewrite({"--check", "--baseline", baseline}).status, 1);
}

}  // namespace
}  // namespace tzc::rewriter
