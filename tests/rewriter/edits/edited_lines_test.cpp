// SPDX-License-Identifier: BSD-3-Clause
#include "edits/edited_lines.h"

#include <gtest/gtest.h>

#include <sstream>

#include "edits/apply.h"
#include "edits/dual.h"

namespace tzc::rewriter {
namespace {

const std::string original = "a\nb\nc\nd\ne\n";

/// An insertion of two lines behind `a`, and `d` replaced.
Edits edits() {
  Edit insertion, replacement;
  insertion.offset = 2;
  insertion.text = "x\ny\n";
  replacement.offset = 6;
  replacement.length = 1;
  replacement.text = "D";
  return {replacement, insertion};
}

TEST(EditedLines, exact_where_nothing_was_formatted) {
  const std::string edited = *apply_edits(original, edits());
  ASSERT_EQ(edited, "a\nx\ny\nb\nc\nD\ne\n");
  const EditedLines lines(original, edits(), edited);
  const unsigned expected[] = {1, 2, 2, 2, 3, 4, 5};
  for (unsigned line = 1; line <= 7; ++line) {
    EXPECT_EQ(lines.original(line).first, expected[line - 1]) << line;
    EXPECT_EQ(lines.original(line).last, expected[line - 1]) << line;
  }
}

TEST(EditedLines, an_edit_that_two_components_make_counts_once) {
  Edits twice = edits();
  for (const Edit& edit : edits()) twice.push_back(edit);
  const std::string edited = *apply_edits(original, twice);
  const EditedLines lines(original, twice, edited);
  for (unsigned line = 1; line <= 7; ++line)
    EXPECT_EQ(lines.original(line).first, EditedLines(original, edits(), edited).original(line).first)
        << line;
}

TEST(EditedLines, through_formatting) {
  const EditedLines lines(original, edits(), "a\nx y\nb\nc\n  D\ne\n");
  EXPECT_EQ(lines.original(2).first, 2u);
  EXPECT_EQ(lines.original(4).first, 3u);
  EXPECT_EQ(lines.original(5).first, 4u);
  EXPECT_EQ(lines.original(5).last, 4u);
  EXPECT_EQ(lines.original(6).first, 5u);
}

/// Neighbouring functions of a class, written on a line each.
TEST(EditedLines, of_lines_that_formatting_breaks) {
  const std::string functions = "void f() { a; b; }\nvoid g() { c; d; e; }\nvoid h() { f; }\n";
  Edit edit;
  edit.offset = functions.find("a;");
  edit.length = 1;
  edit.text = "A";
  const EditedLines lines(functions, {edit},
                          "void f() {\n  A;\n  b;\n}\nvoid g() {\n  c;\n  d;\n\n  e;\n}\nvoid h() { f; }\n");
  const unsigned expected[] = {1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3};
  for (unsigned line = 1; line <= 11; ++line) {
    EXPECT_EQ(lines.original(line).first, expected[line - 1]) << line;
    EXPECT_EQ(lines.original(line).last, expected[line - 1]) << line;
  }
}

/// As many lines as before, but not line by line.
TEST(EditedLines, of_lines_that_formatting_breaks_and_joins) {
  const EditedLines lines("f(a,\n  b);\ng(c); h(d);\n", {}, "f(a, b);\ng(c);\nh(d);\n");
  EXPECT_EQ(lines.original(1).first, 1u);
  EXPECT_EQ(lines.original(1).last, 2u);
  EXPECT_EQ(lines.original(2).first, 3u);
  EXPECT_EQ(lines.original(2).last, 3u);
  EXPECT_EQ(lines.original(3).first, 3u);
}

TEST(EditedLines, through_the_branches_of_dual) {
  const std::string edited = *apply_edits(original, edits());
  const std::string dual = *dual_text("f", original, edited);
  const EditedLines lines(original, edits(), dual);
  unsigned number = 0;
  std::istringstream stream(dual);
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line == "D") {
      EXPECT_TRUE(lines.original(number).has(4));
    }
    if (line == "e") {
      EXPECT_EQ(lines.original(number).first, 5u);
    }
  }
}

TEST(EditedLines, a_line_that_is_not_there) {
  const EditedLines lines(original, {}, original);
  EXPECT_EQ(lines.original(3).first, 3u);
  EXPECT_EQ(lines.original(0).last, 1u);
}

}  // namespace
}  // namespace tzc::rewriter
