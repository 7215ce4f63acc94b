// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "report/codes.h"
#include "sample.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// The file golden/NAME; with TZC_REGENERATE in the environment it becomes `actual`.
std::string golden(const std::string& name, const std::string& actual) {
  const std::string path = std::string(GOLDEN_DIR) + "/" + name;
  if (std::getenv("TZC_REGENERATE")) std::ofstream(path) << actual;
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
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
TEST_F(Sarif, paths_are_relative_uris_of_the_package) {
  EXPECT_EQ(run["originalUriBaseIds"]["PACKAGE_demo"]["uri"], "file:///ws/src/demo/");
  PackageReport package = test::sample();
  package.report.sites[2].where.file = "/ws/src/demo/src/my relay%.cpp";
  EXPECT_THAT(to_sarif({package}, "1"), HasSubstr("src/my%20relay%25.cpp"));
}

bool validates(const json& document, const std::string& schema) {
  test::TempDir folder;
  const std::string log = folder.write("log.sarif", document.dump());
  const std::string program =
      "import json, sys, jsonschema; jsonschema.validate(*(json.load(open(name)) for name in sys.argv[1:]))";
  const std::string command =
      "/usr/bin/python3 -c '" + program + "' '" + log + "' '" + schema + "' 2>/dev/null";
  return std::system(command.c_str()) == 0;
}
const std::string in_use = SOURCE_DIR "/sarif_2_1_0_in_use.schema.json";

/// The standard's own schema is OASIS' and not ours to ship: TZC_SARIF_SCHEMA may name a copy of
/// sarif-schema-2.1.0.json. Ours says less, and forbids all that it does not say.
TEST_F(Sarif, validates_against_the_schema) {
  EXPECT_TRUE(validates(document, in_use));
  if (const char* whole = std::getenv("TZC_SARIF_SCHEMA")) EXPECT_TRUE(validates(document, whole));
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

TEST(HtmlReport, golden_body) {
  const std::string page = to_html({test::sample()});
  const std::string body = page.substr(page.find("<body>"));
  EXPECT_EQ(body, golden("report_body.html", body));
}
TEST(HtmlReport, needs_nothing_else) {
  const std::string page = to_html({test::sample()});
  for (const char* reference : {"http://", "https://", "src=", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(reference)));
}
TEST(HtmlReport, escapes_what_comes_from_the_source) {
  PackageReport package = test::sample();
  package.report.sites[0].topic = "<script>alert(1)</script>";
  package.changes[0].after = "<script>";
  EXPECT_THAT(to_html({package}), Not(HasSubstr("<script>")));
}
TEST(HtmlReport, every_element_is_closed) {
  const std::string page = to_html({test::sample()});
  for (const char* name :
       {"table", "tr", "td", "div", "details", "summary", "ol", "ul", "li", "p", "span", "code", "a"}) {
    const auto count = [&](const std::string& pattern) {
      const std::regex regex(pattern);
      return std::distance(std::sregex_iterator(page.begin(), page.end(), regex), std::sregex_iterator());
    };
    EXPECT_EQ(count(std::string("<") + name + "[ >]"), count(std::string("</") + name + ">")) << name;
  }
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
TEST(ShownChain, one_step_that_repeats_the_reason_is_not_shown) {
  Site site = test::site(SiteKind::publish, "a.cpp", 1, "sensor_msgs/Image", Level::one_copy);
  site.reason = "r";
  site.chain = {{site.where, "r"}};
  EXPECT_TRUE(shown_chain(site).empty());
  site.chain.push_back({site.where, "s"});
  EXPECT_EQ(shown_chain(site).size(), 2u);
}

TEST(Codes, ascending_and_unique) {
  std::string last;
  for (const CodeInfo& info : all_codes()) {
    EXPECT_LT(last, info.code);
    EXPECT_TRUE(std::regex_match(std::string(info.code), std::regex("TZC[1-4][0-9]{3}"))) << info.code;
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
    for (const char* heading : {"## What was seen\n", "## Why it is so\n", "## What to do\n"})
      EXPECT_THAT(std::string(info.page), HasSubstr(heading)) << info.code;
    EXPECT_EQ(info.page.find("## Before") == std::string_view::npos,
              info.page.find("## After") == std::string_view::npos)
        << info.code;
  }
}

}  // namespace
}  // namespace tzc::rewriter
