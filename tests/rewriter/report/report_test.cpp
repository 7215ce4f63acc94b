// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "model/codes.h"
#include "report/code_pages.h"
#include "report/utf16.h"
#include "sample.h"
#include "support/golden_case.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

std::string golden(const std::string& name, const std::string& actual) {
  return tzc::test::golden_file(std::string(GOLDEN_DIR) + "/" + name, actual);
}

TEST(TextReport, golden) {
  const std::string text = to_text(test::sample(), {});
  EXPECT_EQ(text, golden("report.txt", text));
}
TEST(TextReport, colours_only_where_they_are_wanted) {
  EXPECT_THAT(to_text(test::sample(), {}), Not(HasSubstr("\033[")));
  TextStyle style;
  style.colour = true;
  EXPECT_THAT(to_text(test::sample(), style), HasSubstr("\033[32mzero_copy\033[0m"));
}
TEST(TextReport, what_is_said_of_many_files_is_said_once) {
  PackageReport package;
  package.report.package = "driver";
  package.report.package_dir = "/ws/driver";
  const auto note = [&](const std::string& file, const std::string& text) {
    package.report.notes.push_back({"TZC3001", Location{"/ws/driver/" + file, 1, 1}, text});
  };
  for (const char* file : {"demo/a.cpp", "demo/b.cpp", "test/c.cpp", "d.cpp"}) note(file, "left out");
  EXPECT_THAT(to_text(package, {}), HasSubstr("  TZC3001 test/c.cpp:1:1: left out\n"));
  note("test/e.cpp", "left out");
  note("test/f.cpp", "something else");
  package.report.notes.push_back({"TZC4001", {}, "no file"});
  EXPECT_THAT(to_text(package, {}), HasSubstr("  TZC3001 5 files, of each: left out\n"
                                              "      .: 1\n      demo: 2\n      test: 2\n"
                                              "  TZC3001 test/f.cpp:1:1: something else\n"
                                              "  TZC4001 no file\n"));
}
TEST(TextReport, package_without_sites) {
  PackageReport none;
  none.report.package = "none";
  EXPECT_EQ(to_text(none, {}), "none\n  no advertise, publish or subscribe site\n");
}

TEST(JsonReport, golden) {
  const std::string text = to_json({test::sample()});
  EXPECT_EQ(text, golden("report.json", text));
}
TEST(JsonReport, topic_is_null_when_it_is_no_constant) {
  EXPECT_TRUE(json::parse(to_json({test::sample()}))["sites"][2]["topic"].is_null());
}
TEST(JsonReport, several_packages) {
  const json all = json::parse(to_json({test::sample(), test::sample()}));
  EXPECT_EQ(all["version"], 1);
  EXPECT_EQ(all["packages"].size(), 2u);
}
TEST(JsonReport, broken_utf8_in_the_source_is_replaced) {
  PackageReport package = test::sample();
  package.report.sites[0].reason = "caf\xe9";
  EXPECT_NO_THROW(json::parse(to_json({package})));
}

bool validates(const json& document, const std::string& schema) {
  tzc::test::TempDir folder;
  const std::string log = folder.write("log.sarif", document.dump());
  const std::string program =
      "import json, sys, jsonschema; jsonschema.validate(*(json.load(open(name)) for name in sys.argv[1:]))";
  const std::string command =
      "/usr/bin/python3 -c '" + program + "' '" + log + "' '" + schema + "' 2>/dev/null";
  return std::system(command.c_str()) == 0;
}
const std::string in_use = SOURCE_DIR "/sarif_2_1_0_in_use.schema.json";

class Sarif : public ::testing::Test {
 protected:
  json document = json::parse(to_sarif({test::sample()}, "1.2.3"));
  json& run = document["runs"][0];
};
TEST_F(Sarif, golden_without_the_rules) {
  json stripped = document;
  stripped["runs"][0]["tool"]["driver"].erase("rules");
  for (json& result : stripped["runs"][0]["results"]) result.erase("ruleIndex");
  const std::string text = stripped.dump(2) + "\n";
  EXPECT_EQ(text, golden("report.sarif", text));
}
TEST_F(Sarif, each_result_points_at_its_rule) {
  for (const json& result : run["results"])
    EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<int>()]["id"], result["ruleId"]);
}
TEST_F(Sarif, every_code_is_a_rule_with_help) {
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), all_codes().size());
  for (const json& rule : run["tool"]["driver"]["rules"])
    EXPECT_FALSE(rule["help"]["text"].get<std::string>().empty());
}
TEST_F(Sarif, paths_are_relative_uris_of_the_repository) {
  EXPECT_EQ(run["originalUriBaseIds"]["SRCROOT"]["uri"], "file:///ws/src/");
  PackageReport package = test::sample();
  package.report.sites[2].where.file = "/ws/src/demo/src/my relay%.cpp";
  EXPECT_THAT(to_sarif({package}, "1"), HasSubstr("\"demo/src/my%20relay%25.cpp\""));
  for (const json& result : run["results"])
    for (const json& location : result["locations"])
      EXPECT_EQ(location["physicalLocation"]["artifactLocation"]["uriBaseId"], "SRCROOT");
}
TEST_F(Sarif, each_repository_has_a_base_of_its_own) {
  PackageReport other = test::sample();
  other.source_root.clear();
  const json bases = json::parse(to_sarif({test::sample(), other}, "1"))["runs"][0]["originalUriBaseIds"];
  EXPECT_EQ(bases, (json{{"SRCROOT", {{"uri", "file:///ws/src/"}}},
                         {"SRCROOT2", {{"uri", "file:///ws/src/demo/"}}}}));
}
TEST_F(Sarif, runs_over_other_packages_are_told_apart) {
  EXPECT_EQ(run["automationDetails"]["id"], "tzc-rewrite/demo/");
  PackageReport other = test::sample();
  other.report.package = std::string(200, 'x');
  const json both = json::parse(to_sarif({test::sample(), other}, "1"))["runs"][0]["automationDetails"]["id"];
  other.report.package.back() = 'y';
  EXPECT_NE(json::parse(to_sarif({test::sample(), other}, "1"))["runs"][0]["automationDetails"]["id"], both);
}

/// The text after the replacements of a fix, made by what SARIF says of them: from the last one to the first.
std::string fixed(std::string text, const json& replacements) {
  for (auto it = replacements.rbegin(); it != replacements.rend(); ++it) {
    const auto offset = [&](int line, int column) {
      std::size_t at = 0;
      for (; line > 1; --line) at = text.find('\n', at) + 1;
      return at + static_cast<std::size_t>(column - 1);  // the test's lines are ASCII where it matters
    };
    const json& region = (*it)["deletedRegion"];
    const std::size_t begin = offset(region["startLine"], region["startColumn"]);
    const std::size_t end = offset(region["endLine"], region["endColumn"]);
    text.replace(begin, end - begin,
                 it->contains("insertedContent") ? (*it)["insertedContent"]["text"] : json(""));
  }
  return text;
}
TEST_F(Sarif, the_fix_of_a_site_is_the_port_of_its_package) {
  const PackageReport sample = test::sample();
  int pending = 0;
  for (const json& result : run["results"]) {
    if (result["ruleId"] != "TZC5001") continue;
    ++pending;
    EXPECT_EQ(result["level"], "warning");
    const json& changes = result["fixes"][0]["artifactChanges"];
    ASSERT_EQ(changes.size(), sample.changes.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
      EXPECT_EQ(changes[i]["artifactLocation"]["uri"], "demo/" + sample.changes[i].path);
      EXPECT_EQ(fixed(sample.changes[i].before, changes[i]["replacements"]), sample.changes[i].after);
    }
  }
  EXPECT_EQ(pending, 2);
}
TEST_F(Sarif, a_fix_takes_every_form_of_change) {
  const std::pair<const char*, const char*> forms[] = {{"a\nb\n", "b\n"},
                                                       {"a\n", "a\nb\n"},
                                                       {"a", "b"},
                                                       {"a", "a\nb"},
                                                       {"a\nb", "a"},
                                                       {"", "a\n"},
                                                       {"a\nb\nc\nd\n", "0\na\nB\nc\n"},
                                                       {"a\r\nb\r\n", "a\r\nc\r\n"},
                                                       {"a\n\xc3\xa9", "a\nx\n"}};
  for (const auto& [before, after] : forms) {
    PackageReport package = test::sample();
    package.changes = {{"file", before, after}};
    const json log = json::parse(to_sarif({package}, "1.2.3"));
    EXPECT_TRUE(validates(log, in_use)) << before;
    const json result = log["runs"][0]["results"].back();
    const json replacements = result["fixes"][0]["artifactChanges"][0]["replacements"];
    if (std::string(before).find('\xc3') != std::string::npos)
      EXPECT_EQ(replacements[0]["deletedRegion"]["endColumn"], 2) << "one UTF-16 unit";
    else
      EXPECT_EQ(fixed(before, replacements), after);
  }
}
TEST_F(Sarif, columns_are_counted_in_utf16) {
  tzc::test::TempDir folder;
  const std::string source =
      "\n/* \xc3\xa9 \xf0\x9f\x98\x80 */ publish();\n";  // two bytes, one unit; four bytes, two units
  const auto byte_column = static_cast<unsigned>(source.find("publish"));  // the line begins at 1
  PackageReport package = test::sample();
  for (const bool is_written : {false, true}) {
    Location& where = package.report.sites[2].where;
    where = {is_written ? package.report.package_dir + "/CMakeLists.txt" : folder.write("source.cpp", source),
             2, byte_column};
    if (is_written) package.changes[0].before = source;  // it is no longer on the disk
    const json log = json::parse(to_sarif({package}, "1"));
    const json region = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"];
    EXPECT_EQ(region["startColumn"], byte_column - 3) << region;
  }
}
TEST_F(Sarif, a_column_that_the_source_does_not_have_stays) {
  EXPECT_EQ(utf16_column("a\n", 1, 7), 7u);
  EXPECT_EQ(utf16_column("a\n", 9, 7), 7u);
  EXPECT_EQ(utf16_column("", 1, 0), 0u);
}
TEST_F(Sarif, a_large_port_is_in_the_file_once) {
  PackageReport package = test::sample();
  package.changes[0].after = std::string(3u << 20, 'x') + "\n";
  const json log = json::parse(to_sarif({package}, "1"));
  int fixes = 0;
  for (const json& result : log["runs"][0]["results"]) fixes += result.contains("fixes");
  EXPECT_EQ(fixes, 1);
}

/// The standard's own schema is OASIS' and not ours to ship: TZC_SARIF_SCHEMA may name a copy of
/// sarif-schema-2.1.0.json. Ours says less, and forbids all that it does not say.
TEST_F(Sarif, validates_against_the_schema) {
  EXPECT_TRUE(validates(document, in_use));
  if (const char* whole = std::getenv("TZC_SARIF_SCHEMA")) {
    EXPECT_TRUE(validates(document, whole));
  }
}
TEST_F(Sarif, the_schema_finds_what_is_wrong) {
  json wrong = document;
  wrong["runs"][0]["results"][0]["level"] = "fatal";
  EXPECT_FALSE(validates(wrong, in_use));
  wrong = document;
  wrong["runs"][0]["results"][0].erase("message");
  EXPECT_FALSE(validates(wrong, in_use));
  wrong = document;
  wrong["runs"][0]["results"][0]["invented"] = 1;
  EXPECT_FALSE(validates(wrong, in_use));
}

TEST(IsRefusal, plain_unless_somebody_wants_it_so) {
  Site site = test::site(SiteKind::publish, "a.cpp", 1, "sensor_msgs/Image", Level::plain);
  site.code = codes::TZC1001;
  EXPECT_TRUE(is_refusal(site));
  site.code = codes::TZC1016;
  EXPECT_FALSE(is_refusal(site));
  site.code = codes::TZC1001;
  site.suppressed = true;
  EXPECT_FALSE(is_refusal(site));
  site.level = Level::one_copy;
  site.suppressed = false;
  EXPECT_FALSE(is_refusal(site));
}
TEST(ShownChain, one_step_that_repeats_the_reason_and_the_line_is_not_shown) {
  Site site = test::site(SiteKind::publish, "a.cpp", 1, "sensor_msgs/Image", Level::one_copy);
  site.reason = "r";
  site.flow_path = {{site.where, "r"}};
  EXPECT_TRUE(shown_flow_path(site).empty());
  site.flow_path[0].where.line = 7;
  ASSERT_EQ(shown_flow_path(site).size(), 1u);
  EXPECT_EQ(shown_flow_path(site)[0].what, "here") << "the reason does not say where";
  site.flow_path.push_back({site.where, "s"});
  EXPECT_EQ(shown_flow_path(site).size(), 2u);
}

TEST(Codes, ascending_and_unique) {
  std::string last;
  for (const CodeInfo& info : all_codes()) {
    EXPECT_LT(last, info.code);
    EXPECT_TRUE(std::regex_match(std::string(info.code), std::regex("TZC[1-5][0-9]{3}"))) << info.code;
    last = info.code;
  }
}
TEST(Codes, slugs_are_unique_words) {
  std::set<std::string> slugs;
  for (const CodeInfo& info : all_codes()) {
    EXPECT_TRUE(slugs.insert(std::string(info.slug)).second) << info.slug;
    EXPECT_TRUE(std::regex_match(std::string(info.slug), std::regex("[a-z0-9]+(-[a-z0-9]+)*"))) << info.slug;
  }
}
TEST(Codes, each_has_a_page_of_the_common_form) {
  for (const CodeInfo& info : all_codes()) {
    const std::string title =
        "# " + std::string(info.code) + " " + std::string(info.slug) + ": " + std::string(info.title) + "\n";
    EXPECT_EQ(std::string(info.page.substr(0, title.size())), title);
    for (const char* heading : {"## Cause\n", "## Why it matters\n", "## Fix\n"})
      EXPECT_THAT(std::string(info.page), HasSubstr(heading)) << info.code;
    EXPECT_EQ(info.page.find("## Before") == std::string_view::npos,
              info.page.find("## After") == std::string_view::npos)
        << info.code;
  }
}

}  // namespace
}  // namespace tzc::rewriter
