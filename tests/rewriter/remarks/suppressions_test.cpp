// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/suppressions.h"

#include <gtest/gtest.h>

#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

/// A source with one site (code TZC1004) on the line that holds "SITE"; says what became of it, then the
/// notes.
std::string outcome(const std::string& source) {
  tzc::test::TempDir folder;
  Report report;
  Site site;
  site.where.file = folder.write("a.cpp", source);
  const std::size_t at = source.find("SITE");
  site.where.line = 1 + static_cast<unsigned>(std::count(source.begin(), source.begin() + at, '\n'));
  site.code = "TZC1004";
  report.sites.push_back(site);
  apply_suppressions(report, {site.where.file});
  std::string text =
      report.sites[0].suppressed ? "suppressed: " + report.sites[0].suppression_reason : "open";
  for (const Note& note : report.notes) text += ", " + note.code + " at " + std::to_string(note.where->line);
  return text;
}

TEST(Suppressions, on_the_line) {
  EXPECT_EQ(outcome("SITE;  // tzc-ignore[TZC1004]: as is"), "suppressed: as is");
}
TEST(Suppressions, on_the_line_above) {
  EXPECT_EQ(outcome("\n  // tzc-ignore[TZC1004]: as is\n  SITE;"), "suppressed: as is");
}
TEST(Suppressions, above_other_comments) {
  EXPECT_EQ(outcome("// tzc-ignore[TZC1004]: as is\n// more\nSITE;"), "suppressed: as is");
}
TEST(Suppressions, several_codes) {
  EXPECT_EQ(outcome("SITE; // tzc-ignore[TZC1001, TZC1004]: x"), "suppressed: x");
}
TEST(Suppressions, windows_line_endings) {
  EXPECT_EQ(outcome("// tzc-ignore[TZC1004]: x\r\nSITE;\r\n"), "suppressed: x");
}
TEST(Suppressions, another_code_does_not_count) {
  EXPECT_EQ(outcome("SITE; // tzc-ignore[TZC1001]: x"), "open, TZC3006 at 1");
}
TEST(Suppressions, two_lines_above_does_not_count) {
  EXPECT_EQ(outcome("// tzc-ignore[TZC1004]: x\nint a;\nSITE;"), "open, TZC3006 at 1");
}
TEST(Suppressions, behind_the_code_of_the_line_above_does_not_count) {
  EXPECT_EQ(outcome("int a; // tzc-ignore[TZC1004]: x\nSITE;"), "open, TZC3006 at 1");
}
TEST(Suppressions, behind_the_end_of_a_statement_that_was_broken_into_lines) {
  EXPECT_EQ(outcome("int a;\nx =\n    SITE(1,\n         this);  // tzc-ignore[TZC1004]: as is\n"),
            "suppressed: as is");
  EXPECT_EQ(outcome("SITE(1, [](int m) {\n  use(m);\n});  // tzc-ignore[TZC1004]: as is\n"),
            "suppressed: as is");
}
TEST(Suppressions, above_a_statement_that_was_broken_into_lines) {
  EXPECT_EQ(outcome("// tzc-ignore[TZC1004]: as is\nx =\n    SITE(1);\n"), "suppressed: as is");
}
TEST(Suppressions, of_another_statement_do_not_count) {
  EXPECT_EQ(outcome("SITE;\nf(1,\n  2);  // tzc-ignore[TZC1004]: x"), "open, TZC3006 at 3");
  EXPECT_EQ(outcome("SITE;\n}  // tzc-ignore[TZC1004]: x"), "open, TZC3006 at 2");
  EXPECT_EQ(outcome("f([] {\n  SITE;\n  b();  // tzc-ignore[TZC1004]: x\n});"), "open, TZC3006 at 3");
  EXPECT_EQ(outcome("// tzc-ignore[TZC1004]: x\nf(1,\n  2);\nSITE;"), "open, TZC3006 at 1");
}
/// Initialisers of members look like one statement.
TEST(Suppressions, on_a_line_with_a_site_leave_the_lines_before_it_alone) {
  tzc::test::TempDir folder;
  const std::string file =
      folder.write("a.cpp", "Node() : a(f(1)),\n  b(f(2)) {}  // tzc-ignore[TZC1004]: as is\n");
  Report report;
  for (const unsigned line : {1u, 2u}) {
    report.sites.emplace_back();
    report.sites.back().where = {file, line, 1};
    report.sites.back().code = "TZC1004";
  }
  apply_suppressions(report, {file});
  EXPECT_FALSE(report.sites[0].suppressed);
  EXPECT_TRUE(report.sites[1].suppressed);
}
TEST(Suppressions, need_a_reason) {
  EXPECT_EQ(outcome("SITE; // tzc-ignore[TZC1004]"), "open, TZC3005 at 1");
  EXPECT_EQ(outcome("SITE; // tzc-ignore[TZC1004]:  "), "open, TZC3005 at 1");
}
TEST(Suppressions, need_codes) {
  EXPECT_EQ(outcome("SITE; // tzc-ignore: all of it"), "open, TZC3005 at 1");
  EXPECT_EQ(outcome("//tzc-ignore\nSITE;"), "open, TZC3005 at 1");
  EXPECT_EQ(outcome("SITE; // what tzc-ignore would hide"), "open");
}
TEST(Suppressions, need_a_known_code) {
  EXPECT_EQ(outcome("SITE; // tzc-ignore[TZC0815]: x"), "open, TZC3005 at 1");
  EXPECT_EQ(outcome("SITE; // tzc-ignore[]: x"), "open, TZC3005 at 1");
}

}  // namespace
}  // namespace tzc::rewriter
