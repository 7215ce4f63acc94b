// SPDX-License-Identifier: BSD-3-Clause
#include "paper/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace tzc::bench;
using testing::HasSubstr;
using testing::Not;

nlohmann::json run_of(const char* span) {
  return {{"begun", "a day"},
          {"machine", {{"cpu", "<x>"}}},
          {"versions", {{"tzc", "1"}}},
          {"settings", {{"span", span}}}};
}

Section with_rows(std::size_t rows) {
  return {"Heading", "<p>Text.</p>\n", "a.csv", {{"plot-1", "<svg/>"}}, {{"x", "y"}, {rows, {"1", "2"}}}};
}

TEST(Page, says_which_span_was_measured) {
  EXPECT_THAT(page_of(run_of("publish"), {}), HasSubstr("none writes new"));
  EXPECT_THAT(page_of(run_of("allocate, fill, publish"), {}), HasSubstr("writing every byte"));
  EXPECT_THAT(page_of(run_of("allocate, fill, publish"), {}), Not(HasSubstr("none writes new")));
}

TEST(Markdown, refers_to_the_files_beside_it) {
  const std::string text = markdown_of(run_of("publish"), {with_rows(1)});
  EXPECT_THAT(text, HasSubstr("begun a day"));
  EXPECT_THAT(text, HasSubstr("- cpu: &lt;x&gt;\n"));
  EXPECT_THAT(text, HasSubstr("## Heading\n\n<p>Text.</p>\n\n![plot-1](plot-1.svg)\n"));
  EXPECT_THAT(text, HasSubstr("| x | y |\n| --- | --- |\n| 1 | 2 |\n"));
  EXPECT_THAT(text, HasSubstr("[a.csv](a.csv): 1 rows."));
}

TEST(Markdown, leaves_long_tables_to_their_files) {
  const std::string text = markdown_of(run_of("publish"), {with_rows(1000), with_rows(0)});
  EXPECT_THAT(text, Not(HasSubstr("| 1 | 2 |")));
  EXPECT_THAT(text, HasSubstr("[a.csv](a.csv): 1000 rows."));
  EXPECT_EQ(text.find("## Heading"), text.rfind("## Heading"));
}

}  // namespace
